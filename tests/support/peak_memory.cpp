#include "support/peak_memory.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

namespace bondstatic::test {

namespace {

double status_bytes(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.rfind(name + ":", 0) == 0) return 1024 * std::strtod(line.c_str() + name.size() + 1, nullptr);
  return 0;
}

}  // namespace

void PeakMemory::begin() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;  // the peak is what stands now
  stood_ = status_bytes("VmRSS");
}

double PeakMemory::bytes() const {
  return std::max(0.0, status_bytes("VmHWM") - stood_);
}

}  // namespace bondstatic::test
