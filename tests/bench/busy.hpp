// Other people's work on the machine: processes that do nothing but compute.
#pragma once

#include <sys/types.h>

#include <vector>

namespace bondstatic::bench {

/// They compute from the start. To be made before large models: pages that a fork shares are copied when they
/// are next written to, which would be measured, too.
class BusyProcesses {
 public:
  explicit BusyProcesses(int count);
  ~BusyProcesses();
  BusyProcesses(const BusyProcesses&) = delete;
  BusyProcesses& operator=(const BusyProcesses&) = delete;

  void pause();
  void resume();

 private:
  void tell_all(int signal);

  std::vector<pid_t> children_;
};

}  // namespace bondstatic::bench
