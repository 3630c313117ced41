#include "bench/rates.hpp"

#include <dlfcn.h>

#include <cstddef>
#include <limits>
#include <thread>
#include <vector>

#include "bench/timing.hpp"
#include "solver/machine.hpp"

namespace bondstatic::bench {

namespace {

constexpr int repeats = 4;

using Dgemm = void (*)(const char*, const char*, const int*, const int*, const int*, const double*,
                       const double*, const int*, const double*, const int*, const double*, double*,
                       const int*);

template <class Work>
double best_seconds(Work work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) best = std::min(best, seconds_of(work));
  return best;
}

}  // namespace

double dgemm_rate(int threads) {
  const auto dgemm = reinterpret_cast<Dgemm>(dlsym(RTLD_DEFAULT, "dgemm_"));
  if (!dgemm) return 0;
  const SolverThreads guard(threads);
  constexpr int n = 2000;
  const double one = 1, zero = 0;
  const std::vector<double> a(n * n, 1.1), b(n * n, 0.9);
  std::vector<double> c(n * n);
  const double seconds = best_seconds(
      [&] { dgemm("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, c.data(), &n); });
  return 2.0 * n * n * n / seconds;
}

double triad_rate(int threads) {
  constexpr std::size_t count = 1 << 23;  // 64 MB an array
  std::vector<double> a(count), b(count, 1), c(count, 2);
  const double seconds = best_seconds([&] {
    std::vector<std::thread> team;
    for (int t = 0; t < threads; ++t)
      team.emplace_back([&, t] {
        const std::size_t end = count * std::size_t(t + 1) / std::size_t(threads);
        for (std::size_t i = count * std::size_t(t) / std::size_t(threads); i < end; ++i)
          a[i] = b[i] + 3 * c[i];
      });
    for (std::thread& one : team) one.join();
  });
  return 3.0 * 8 * count / seconds;
}

}  // namespace bondstatic::bench
