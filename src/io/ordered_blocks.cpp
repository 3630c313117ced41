#include "io/ordered_blocks.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>

namespace bondstatic {

void write_blocks(OutputFile& file, Index count, Index block, const FormatItems& format) {
  const Index blocks = (count + block - 1) / block;
  const int threads = int(std::clamp<Index>(blocks, 1, std::max(1, file.threads())));
  std::exception_ptr failure;  // none may leave the threads; set and read in turn only
  std::atomic<bool> given_up = false;
  // OpenMP's ordered would wait actively for the disk, and keep a core from who has work for it.
  std::mutex gate;
  std::condition_variable passed_on;
  Index turn = 0;
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
    fmt::memory_buffer text;
#pragma omp for schedule(static, 1)
    for (Index b = 0; b < blocks; ++b) {
      std::exception_ptr here;
      try {
        text.clear();
        if (!given_up) format(b * block, std::min(count, (b + 1) * block), text);
      } catch (...) {
        here = std::current_exception();
      }
      {
        std::unique_lock hold(gate);
        passed_on.wait(hold, [&] { return turn == b; });
      }
      if (here && !failure) failure = here;
      if (!failure) try {
          file.append({text.data(), text.size()});
        } catch (...) {
          failure = std::current_exception();
        }
      given_up = failure != nullptr;
      {
        const std::lock_guard hold(gate);
        turn = b + 1;
      }
      passed_on.notify_all();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace bondstatic
