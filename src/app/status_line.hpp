// The line that says what is going on while it takes long.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace bondstatic {

/// "write [########            ] 42 %, 5 s left" where it is known which part of a phase is done (else
/// `part` is negative), "refinement, 12 s" where only its time is. The end is foretold from a second on.
std::string status_text(const std::string& what, double seconds, double part);

/// One line on standard error that is written over and over, five times a second and not before a third of a
/// second: short runs show nothing. Nothing at all where that is no terminal, or NO_COLOR is set.
class StatusLine {
 public:
  StatusLine();
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// The phase that has begun, or what is new of it: its first word names it.
  void show(const std::string& what, double part = -1);
  /// Nothing is shown until the next show().
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void tell(const std::stop_token& stop);
  void wipe();

  std::mutex mutex_;  ///< over all below, and the terminal's line
  std::condition_variable_any stopped_;
  std::string what_;
  double part_ = -1;
  Clock::time_point begun_;
  bool shown_ = false;
  std::jthread teller_;  ///< only where there is somebody to tell
};

}  // namespace bondstatic
