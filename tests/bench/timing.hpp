// Seconds on the clock, and of a processor.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace bondstatic::bench {

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Work>
double seconds_of(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Of the calling thread unless another clock is asked for, the system's work for it included: waiting while
/// others have the processor does not count, nor do the threads that OpenBLAS and MPI keep spinning for
/// nothing.
template <clockid_t clock = CLOCK_THREAD_CPUTIME_ID, class Work>
double processor_seconds_of(Work&& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(clock, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
  };
  const double begin = now();
  work();
  return now() - begin;
}

template <class Work>
double median_seconds(int repeats, Work&& work) {
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) seconds.push_back(seconds_of(work));
  return median(std::move(seconds));
}

}  // namespace bondstatic::bench
