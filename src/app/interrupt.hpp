// SIGINT and SIGTERM: at once outside of writing, after cleaning up inside of it. The handler needs a flag
// that outlives every object, which is why interrupt.cpp keeps the program's only mutable globals.
#pragma once

namespace bondstatic {

/// From here on SIGINT ends the program with 130 and SIGTERM with 143. A signal that was ignored at the start
/// (by nohup, or for a job in the background) stays ignored.
void handle_interrupts();

/// While one exists a signal waits, so that half-written files can be removed; it ends the program at the
/// next check, or when the last one goes out of scope.
class DeferredInterrupts {
 public:
  DeferredInterrupts();
  ~DeferredInterrupts();
  DeferredInterrupts(const DeferredInterrupts&) = delete;
  DeferredInterrupts& operator=(const DeferredInterrupts&) = delete;

  /// Throws Error (interrupted, terminated) where a signal is waiting.
  static void check();
  static bool waiting();
};

}  // namespace bondstatic
