// One thread or all of them, whichever is faster just now. A step is so short that threads meet thousands of
// times a second: where another process takes one of their cores, all wait for it, and one thread alone is up
// to a hundred times faster. The bits are the same, so the clock may decide.
#pragma once

#include <algorithm>
#include <chrono>

#include "bondstatic/types.hpp"

namespace bondstatic {

class ThreadChoice {
 public:
  /// Runs so many steps by `work(steps, together)`.
  template <class Work>
  void operator()(Index steps, Work work) {
    // Threads take a few steps to get up; what they then need is what counts. A trial is short, and the first
    // ones meet memory and cores that are not warm: they are soon repeated, later ones seldom.
    constexpr Index warm_up = 2, trial = 4, longest_pause = 64;
    if (calls_++ >= next_trial_ && steps > 2 * (warm_up + trial)) {
      next_trial_ = calls_ + pause_;
      pause_ = std::min(2 * pause_, longest_pause);
      work(warm_up, !together_);
      timed(trial, !together_, work);
      steps -= warm_up + trial;
    }
    timed(steps, together_, work);
    if (cost_[!together_] < 0.9 * cost_[together_]) together_ = !together_;
  }

 private:
  template <class Work>
  void timed(Index steps, bool together, Work work) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    work(steps, together);
    cost_[together] = std::chrono::duration<double>(Clock::now() - begin).count() / double(steps);
  }

  bool together_ = false;
  Index calls_ = 0, next_trial_ = 0, pause_ = 1;
  double cost_[2] = {1e300, 1e300};  ///< seconds a step, alone and together
};

}  // namespace bondstatic
