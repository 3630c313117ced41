// A forked copy of the test that runs one function, to be killed or to fail on its own.
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

namespace bondstatic::test {

class ChildProcess {
 public:
  /// `body` returns the exit status; 100 stands for an exception.
  template <class Body>
  explicit ChildProcess(Body body) : process_(fork()) {
    if (process_ < 0) throw std::runtime_error("cannot fork");
    if (process_ > 0) return;
    int status = 100;
    try {
      status = body();
    } catch (...) {
    }
    _exit(status);
  }
  ~ChildProcess() {
    if (process_ > 0) kill();
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The exit status; -1 where a signal ended it.
  int wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  void kill() {
    ::kill(process_, SIGKILL);
    wait();
  }

 private:
  pid_t process_;
};

}  // namespace bondstatic::test
