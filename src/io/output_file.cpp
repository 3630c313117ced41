#include "io/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

constexpr std::size_t large = std::size_t(1) << 20;

[[noreturn]] void fail(const std::string& path, const char* what, int reason) {
  throw Error(ExitCode::internal, fmt::format("{}: cannot {}: {}", path, what, std::strerror(reason)));
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path, std::string shown, Checkpoint checkpoint)
    : shown_(std::move(shown)), checkpoint_(std::move(checkpoint)) {
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(shown_, "open for writing", errno);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::append(std::string_view text) {
  // In pieces, so that one large text neither doubles memory nor keeps an interrupt waiting.
  while (!text.empty()) {
    const std::string_view piece = text.substr(0, large);
    buffer_.append(piece.data(), piece.data() + piece.size());
    flush_if_large();
    text.remove_prefix(piece.size());
  }
}

void OutputFile::flush_if_large() {
  if (buffer_.size() >= large) flush();
}

void OutputFile::flush() {
  if (checkpoint_) checkpoint_();
  for (std::size_t done = 0; done < buffer_.size();) {
    const ssize_t count = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(shown_, "write", errno);
    done += std::size_t(count);
  }
  buffer_.clear();
}

void OutputFile::close() {
  flush();
  // Quotas and network file systems report a full disk only here.
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0 && errno != EINTR) fail(shown_, "close", errno);
}

}  // namespace bondstatic
