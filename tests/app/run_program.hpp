// Runs the bondstatic program, or another, as a process of its own.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "io/scratch_folder.hpp"

namespace bondstatic::test {

/// Exit status as a shell tells it: 128 + signal where one killed it.
struct Ended {
  int code = -1;
  std::string out;
  std::string err;
};

class Program {
 public:
  explicit Program(std::vector<std::string> arguments, const std::string& program = BONDSTATIC_PROGRAM) {
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    // Made here, so that they are there even where the process is killed before it runs.
    const std::string out = streams_.write("out", ""), err = streams_.write("err", "");
    process_ = fork();
    if (process_ != 0) return;
    // A test runner in the background may have left SIGINT ignored, which would be inherited.
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    dup2(open("/dev/null", O_RDONLY), 0);
    dup2(open(out.c_str(), O_WRONLY), 1);
    dup2(open(err.c_str(), O_WRONLY), 2);
    execv(argv[0], argv.data());
    _exit(127);
  }
  ~Program() {
    if (process_ > 0) end();
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  pid_t id() const { return process_; }
  void send(int signal) const { kill(process_, signal); }

  bool running() const {
    siginfo_t info{};
    return waitid(P_PID, id_t(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
  }

  Ended end() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(streams_ / "out"),
            read_text(streams_ / "err")};
  }

 private:
  ScratchFolder streams_;
  pid_t process_ = 0;
};

inline Ended run_program(std::vector<std::string> arguments) {
  return Program(std::move(arguments)).end();
}

/// [Chen2022] case 1, the reference cantilever, tip deflection in mm.
inline std::string cantilever() {
  return R"(title = "cantilever"
[[particles]]
line = { from = [0, 0, 0], to = [4, 0, 0], count = 11 }
radius = 0.2
[[bonds]]
law = "timoshenko"
young = 200e9
poisson = 0.3
radius = 0.2
[[supports]]
at = { id = 1 }
fix = "all"
[[loads]]
at = { id = 11 }
force = [0, -100e3, 0]
[[outputs]]
name = "tip"
of = "uy"
at = { id = 11 }
scale = 1e3
expected = -8.534241726238742
source = "[Chen2022] Eq. 29"
)";
}

}  // namespace bondstatic::test
