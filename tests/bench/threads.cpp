#include "bench/threads.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace bondstatic::bench {

int machine_cores() {
  return int(sysconf(_SC_NPROCESSORS_ONLN));
}

std::vector<int> thread_counts() {
  std::vector<int> counts{1};
  for (int t = 2; t <= machine_cores(); t *= 2) counts.push_back(t);
  return counts;
}

std::string plural(int threads) {
  return fmt::format("{} thread{}", threads, threads == 1 ? "" : "s");
}

StaticOptions on_threads(const std::string& solver, int threads) {
  StaticOptions options;
  options.solver = solver;
  options.threads = threads;
  return options;
}

}  // namespace bondstatic::bench
