// Other people's work on the machine: processes that do nothing but compute.
#pragma once

#include <sys/types.h>

#include <vector>

namespace bondstatic::bench {

class BusyProcesses {
 public:
  explicit BusyProcesses(int count);
  ~BusyProcesses();
  BusyProcesses(const BusyProcesses&) = delete;
  BusyProcesses& operator=(const BusyProcesses&) = delete;

 private:
  std::vector<pid_t> children_;
};

}  // namespace bondstatic::bench
