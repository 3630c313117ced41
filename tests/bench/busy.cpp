#include "bench/busy.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

namespace bondstatic::bench {

BusyProcesses::BusyProcesses(int count) {
  for (int i = 0; i < count; ++i) {
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child > 0) {
      children_.push_back(child);
      continue;
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // none must outlive the benchmark
    volatile double x = 1;
    for (;;) x = x * 1.0000001 + 1e-9;
  }
}

BusyProcesses::~BusyProcesses() {
  for (const pid_t child : children_) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
}

void BusyProcesses::tell_all(int signal) {
  for (const pid_t child : children_) kill(child, signal);
}

void BusyProcesses::pause() {
  tell_all(SIGSTOP);
}

void BusyProcesses::resume() {
  tell_all(SIGCONT);
}

}  // namespace bondstatic::bench
