#include "io/replace_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const char* what, const std::string& reason) {
  throw Error(ExitCode::internal, fmt::format("{}: cannot {}: {}", path.string(), what, reason));
}

[[noreturn]] void fail(const fs::path& path, const char* what, int reason) {
  fail(path, what, std::strerror(reason));
}

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) {
    do number_ = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
    while (number_ < 0 && errno == EINTR);
  }
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  bool close() {
    const bool closed = number_ < 0 || ::close(number_) == 0 || errno == EINTR;
    number_ = -1;
    return closed;
  }

 private:
  int number_;
};

void write_all(int file, std::string_view content, const fs::path& path) {
  while (!content.empty()) {
    const ssize_t count = ::write(file, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, "write", errno);
    content.remove_prefix(std::size_t(count));
  }
}

/// Some network file systems have no such call, which is no failure.
template <class Sync>
bool synced(Sync sync, int file) {
  int result;
  do result = sync(file);
  while (result != 0 && errno == EINTR);
  return result == 0 || errno == EINVAL || errno == ENOTSUP || errno == ENOSYS;
}

void fill(int file, std::string_view content, const fs::path& path) {
  write_all(file, content, path);
  // Full disks and quotas may be found out only here.
  if (!synced(::fdatasync, file)) fail(path, "write", errno);
}

/// Gives `content` the name `whole` only once it is on the disk. False where the system cannot do that.
bool write_unnamed(const fs::path& whole, std::string_view content, const fs::path& path) {
  Descriptor file(whole.parent_path(), O_WRONLY | O_TMPFILE);
  if (!file.is_open()) return false;
  fill(file.number(), content, path);
  const std::string open_file = fmt::format("/proc/self/fd/{}", file.number());
  return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, whole.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

void write_named(const fs::path& part, std::string_view content, const fs::path& path) {
  Descriptor file(part, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open()) fail(path, "open for writing", errno);
  try {
    fill(file.number(), content, path);
    if (!file.close()) fail(path, "close", errno);
  } catch (...) {
    ::unlink(part.c_str());
    throw;
  }
}

/// Where the new file goes. A rename would put it in the place of a device or a link itself.
fs::path destination(const fs::path& path) {
  if (!path.has_filename()) fail(path, "write", "it names no file");
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type == fs::file_type::not_found || type == fs::file_type::none) return path;
  if (!fs::is_regular_file(path, error)) fail(path, "replace", "it is not a regular file");
  const fs::path target = type == fs::file_type::symlink ? fs::canonical(path, error) : path;
  if (error) fail(path, "replace", error.message());
  return target;
}

}  // namespace

void replace_file(const fs::path& path, std::string_view content, UnnamedFiles unnamed_files) {
  const fs::path target = destination(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const std::string hidden = "." + target.filename().string();
  const fs::path whole = folder / (hidden + ".new"), part = folder / (hidden + ".part");
  ::unlink(whole.c_str());
  ::unlink(part.c_str());

  // What fails for a reason of its own, such as a folder that is not there, fails again with a name, and is
  // reported then.
  const bool unnamed = unnamed_files == UnnamedFiles::where_known && write_unnamed(whole, content, path);
  if (!unnamed) write_named(part, content, path);
  const fs::path& written = unnamed ? whole : part;
  if (::rename(written.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    ::unlink(written.c_str());
    fail(path, "replace", reason);
  }
  // A folder that may be written to but not read cannot be opened: the rename reaches the disk later then.
  const Descriptor opened(folder, O_RDONLY | O_DIRECTORY);
  if (opened.is_open() && !synced(::fsync, opened.number())) fail(path, "write its folder", errno);
}

std::optional<std::string> read_whole_file(const fs::path& path) {
  const auto unreadable = [&](const std::string& reason) {
    throw Error(ExitCode::invalid_input,
                fmt::format("{}: cannot be read: {}\n    cure: check the path, the permissions and the disk",
                            path.string(), reason));
  };
  // O_NONBLOCK: opening a pipe would wait for a writer.
  const Descriptor file(path, O_RDONLY | O_NONBLOCK);
  if (!file.is_open() && (errno == ENOENT || errno == ENOTDIR)) return std::nullopt;
  if (!file.is_open()) unreadable(std::strerror(errno));
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0) unreadable(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) unreadable("it is not a regular file");

  std::string content(std::size_t(status.st_size), '\0');
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = ::read(file.number(), content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) unreadable(std::strerror(errno));
    if (count == 0) break;
    done += std::size_t(count);
  }
  content.resize(done);
  return content;
}

}  // namespace bondstatic
