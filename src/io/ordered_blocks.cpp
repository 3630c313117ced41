#include "io/ordered_blocks.hpp"

#include <algorithm>
#include <atomic>
#include <exception>

namespace bondstatic {

void write_blocks(OutputFile& file, Index count, Index block, const FormatItems& format) {
  const Index blocks = (count + block - 1) / block;
  const int threads = int(std::clamp<Index>(blocks, 1, std::max(1, file.threads())));
  std::exception_ptr failure;  // none may leave the threads; set and read in turn only
  std::atomic<bool> given_up = false;
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
    fmt::memory_buffer text;
#pragma omp for ordered schedule(static, 1)
    for (Index b = 0; b < blocks; ++b) {
      std::exception_ptr here;
      try {
        text.clear();
        if (!given_up) format(b * block, std::min(count, (b + 1) * block), text);
      } catch (...) {
        here = std::current_exception();
      }
#pragma omp ordered
      {
        if (here && !failure) failure = here;
        if (!failure) try {
            file.append({text.data(), text.size()});
          } catch (...) {
            failure = std::current_exception();
          }
        given_up = failure != nullptr;
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace bondstatic
