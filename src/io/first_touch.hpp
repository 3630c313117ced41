// Large arrays whose memory several threads bring in. The system finds and clears a page when it is first
// touched, a few microseconds each: half a second a gigabyte and more, for which other threads would wait.
#pragma once

#include <cstddef>
#include <vector>

namespace bondstatic {

inline void touch_pages(void* begin, std::size_t bytes, int threads) {
  constexpr std::ptrdiff_t page = 4096;
  constexpr std::size_t worth_threads = std::size_t(1) << 20;
  if (threads < 2 || bytes < worth_threads) return;
  volatile char* const at = static_cast<char*>(begin);
  const std::ptrdiff_t pages = std::ptrdiff_t(bytes) / page;
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::ptrdiff_t p = 0; p < pages; ++p) at[p * page] = 0;
}

/// std::vector<T>(count).
template <class T>
std::vector<T> vector_of(std::size_t count, int threads) {
  std::vector<T> values;
  values.reserve(count);
  touch_pages(values.data(), count * sizeof(T), threads);
  values.resize(count);
  return values;
}

}  // namespace bondstatic
