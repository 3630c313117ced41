// Long work off the interpreter's thread: the caller waits without the GIL, hears of progress, and can be
// interrupted at any time.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace bondstatic {

namespace py = pybind11;

/// Between the work and who waits for it.
class Watch {
 public:
  using Message = std::function<void()>;

  /// By the work: the waiting thread calls the message, with the GIL. Messages hold no Python objects. Throws
  /// where nobody waits any more, which ends the work.
  void tell(Message message);
  bool given_up() const { return given_up_; }

 private:
  friend void run_watched(std::function<void(Watch&)> work);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Message> messages_;
  bool done_ = false;
  std::exception_ptr error_;
  std::atomic<bool> given_up_ = false;
};

/// A callable or None, which the waiting caller keeps: messages may hold this, as they are only called while
/// it waits.
class Callback {
 public:
  Callback() = default;  ///< nobody hears
  explicit Callback(const py::object& callable) : callable_(callable.is_none() ? nullptr : callable.ptr()) {}

  template <class... Given>
  void operator()(const Given&... given) const {
    if (callable_) py::reinterpret_borrow<py::function>(callable_)(given...);
  }

 private:
  PyObject* callable_ = nullptr;
};

/// Runs work(watch) on a thread of its own and returns when it is done; throws what it throws. Signals are
/// looked at while waiting: KeyboardInterrupt, like any exception of a message, is thrown at once, and the
/// work goes on unheard until it next tells something. Whatever it touches must therefore belong to it; no
/// Python objects.
void run_watched(std::function<void(Watch&)> work);

}  // namespace bondstatic
