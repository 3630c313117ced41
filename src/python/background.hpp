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
  /// The same, and returns when the message has been called: what it has found out is then known.
  void ask(Message message);
  bool given_up() const { return given_up_; }

  /// By work that has something to show for itself: from now on the first Ctrl-C is not thrown, but asks it
  /// to stop.
  void stop_on_interrupt() { stoppable_ = true; }
  bool interrupted() const { return interrupted_; }

 private:
  friend void run_watched(std::function<void(Watch&)> work);

  void hear(const Message& message);
  void give_up();

  std::mutex mutex_;
  std::condition_variable changed_, heard_;
  std::vector<Message> messages_;
  std::size_t told_count_ = 0, heard_count_ = 0;
  bool done_ = false;
  std::exception_ptr error_;
  std::atomic<bool> given_up_ = false;
  std::atomic<bool> stoppable_ = false, interrupted_ = false;
};

/// A callable or None, which the waiting caller keeps: messages may hold this, as they are only called while
/// it waits.
class Callback {
 public:
  Callback() = default;  ///< nobody hears
  explicit Callback(const py::object& callable) : callable_(callable.is_none() ? nullptr : callable.ptr()) {}

  explicit operator bool() const { return callable_ != nullptr; }

  /// What the callable returns.
  template <class... Given>
  py::object operator()(const Given&... given) const {
    return callable_ ? py::reinterpret_borrow<py::function>(callable_)(given...) : py::none();
  }

 private:
  PyObject* callable_ = nullptr;
};

/// Runs work(watch) on a thread of its own and returns when it is done; throws what it throws. Signals are
/// looked at while waiting: KeyboardInterrupt (unless it is to stop the work, Watch::stop_on_interrupt), like
/// any exception of a message, is thrown at once, and the work goes on unheard until it next tells something.
/// Whatever it touches must therefore belong to it; no Python objects.
void run_watched(std::function<void(Watch&)> work);

}  // namespace bondstatic
