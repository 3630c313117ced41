// Times the phases of a solve and tells the user as each begins.
#pragma once

#include <chrono>
#include <functional>

#include "bondstatic/statics.hpp"

namespace bondstatic {

class Stopwatch {
 public:
  Stopwatch(std::vector<Phase>& phases, const std::function<void(const std::string&)>& progress)
      : phases_(phases), progress_(progress) {}

  /// Runs `work`, adds its time to the phase of that name, returns what it returns.
  template <class Work>
  auto operator()(const char* phase, Work work) {
    if (progress_) progress_(phase);
    const Lap lap{*this, phase};
    return work();
  }

 private:
  using Clock = std::chrono::steady_clock;

  struct Lap {
    Stopwatch& watch;
    const char* phase;
    Clock::time_point begin = Clock::now();
    ~Lap() { watch.add(phase, std::chrono::duration<double>(Clock::now() - begin).count()); }
  };

  void add(const char* name, double seconds) {
    for (Phase& phase : phases_)
      if (phase.name == name) {
        phase.seconds += seconds;
        return;
      }
    phases_.push_back({name, seconds});
  }

  std::vector<Phase>& phases_;
  const std::function<void(const std::string&)>& progress_;
};

}  // namespace bondstatic
