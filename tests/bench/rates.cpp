#include "bench/rates.hpp"

#include <dlfcn.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "bench/timing.hpp"
#include "solver/machine.hpp"

namespace bondstatic::bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int repeats = 4;

using Dgemm = void (*)(const char*, const char*, const int*, const int*, const int*, const double*,
                       const double*, const int*, const double*, const int*, const double*, double*,
                       const int*);

constexpr std::size_t count = 1 << 23;  // of the triad: 64 MB an array

template <class Work>
double best_seconds(Work work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) best = std::min(best, seconds_of(work));
  return best;
}

double triad_rate_between(Clock::time_point begin, Clock::time_point end) {
  std::vector<double> a(count), b(count, 1), c(count, 2);
  std::this_thread::sleep_until(begin);
  const auto began = Clock::now();
  int sweeps = 0;
  for (; Clock::now() < end; ++sweeps) {
    for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + 3 * c[i];
    asm volatile("" ::"r"(a.data()) : "memory");  // else nobody reads `a`, and the sweep may be left out
  }
  return 3.0 * 8 * count * sweeps / std::chrono::duration<double>(Clock::now() - began).count();
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

double triad_rate_of_processes(int processes) {
  const std::size_t bytes = sizeof(double) * std::size_t(processes);
  void* shared = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw std::runtime_error("no memory to share with children");
  auto* const rates = static_cast<double*>(shared);
  // One clock for all: they begin together, once each has touched its arrays.
  const auto begin = Clock::now() + std::chrono::seconds(1);
  std::vector<pid_t> children;
  for (int p = 0; p < processes; ++p) {
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      rates[p] = triad_rate_between(begin, begin + std::chrono::seconds(1));
      _exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) waitpid(child, nullptr, 0);
  const double rate = std::accumulate(rates, rates + processes, 0.0);
  munmap(shared, bytes);
  return rate;
}

}  // namespace bondstatic::bench
