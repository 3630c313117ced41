// Conditions under which the system refuses to write.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

namespace bondstatic::test {

/// Limits the size of files while it lives, which makes writes fail as a full disk does.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

/// Permissions hold for root, too, while it lives.
class WithoutRoot {
 public:
  WithoutRoot() : user_(geteuid()) {
    if (user_ == 0 && seteuid(65534) != 0) user_ = 65534;
  }
  ~WithoutRoot() {
    if (user_ == 0 && seteuid(0) != 0) _exit(1);
  }
  WithoutRoot(const WithoutRoot&) = delete;
  WithoutRoot& operator=(const WithoutRoot&) = delete;

 private:
  uid_t user_;
};

}  // namespace bondstatic::test
