#include "io/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

constexpr std::size_t large = std::size_t(1) << 20;

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

[[noreturn]] void fail(const std::string& path, const char* what, int reason) {
  throw Error(ExitCode::internal, fmt::format("{}: cannot {}: {}", path, what, std::strerror(reason)));
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path, std::string shown, Checkpoint checkpoint,
                       int threads, Begin begin, std::atomic<Index>* written)
    : shown_(std::move(shown)), checkpoint_(std::move(checkpoint)), threads_(threads), written_(written) {
  const int start = begin == Begin::empty ? O_CREAT | O_TRUNC : O_APPEND;
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | start, 0666);
  if (descriptor_ < 0) fail(shown_, "open for writing", errno);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::append(std::string_view text) {
  // What is long is not copied again.
  constexpr std::size_t worth_a_call = std::size_t(1) << 16;
  if (text.size() < worth_a_call) {
    buffer_.append(text.data(), text.data() + text.size());
    return flush_if_large();
  }
  flush();
  // In pieces, so that one large text does not keep an interrupt waiting.
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), large))) {
    if (checkpoint_) checkpoint_();
    write(text.substr(0, large));
  }
}

void OutputFile::append_file(const std::filesystem::path& path) {
  const Descriptor from{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (from.number < 0) fail(path.string(), "open for reading", errno);
  std::vector<char> block(large);
  for (;;) {
    const ssize_t count = ::read(from.number, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path.string(), "read", errno);
    if (count == 0) return;
    append({block.data(), std::size_t(count)});
  }
}

void OutputFile::flush_if_large() {
  if (buffer_.size() >= large) flush();
}

void OutputFile::flush() {
  if (checkpoint_) checkpoint_();
  write({buffer_.data(), buffer_.size()});
  buffer_.clear();
}

void OutputFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(shown_, "write", errno);
    text.remove_prefix(std::size_t(count));
    if (written_) *written_ += count;
  }
}

void OutputFile::close() {
  flush();
  // Quotas and network file systems report a full disk only here.
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0 && errno != EINTR) fail(shown_, "close", errno);
}

}  // namespace bondstatic
