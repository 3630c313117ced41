#include "python/background.hpp"

#include <cxxabi.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <utility>

#include "python/parts.hpp"

namespace bondstatic {

namespace {

constexpr auto between_looks = std::chrono::milliseconds(50);

std::atomic<int> running = 0;

/// Static objects must not be destroyed under work that goes on unheard.
void end_at_once(int status, void*) {
  if (running == 0) return;
  std::fflush(nullptr);
  _exit(status);
}

/// Signals are the interpreter's business: a thread born while this lives gets none.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

struct GivenUp {};

/// Where the interpreter has ended meanwhile, this thread would be ended here, and its unwinding touch Python
/// objects: it sleeps until the process is gone instead.
void take_gil_back(PyThreadState* state) {
  try {
    PyEval_RestoreThread(state);
  } catch (const abi::__forced_unwind&) {
    for (;;) pause();
  }
}

}  // namespace

void Watch::tell(Message message) {
  if (given_up_) throw GivenUp{};
  const std::lock_guard lock(mutex_);
  messages_.push_back(std::move(message));
  ++told_count_;
  changed_.notify_one();
}

void Watch::ask(Message message) {
  tell(std::move(message));
  std::unique_lock lock(mutex_);
  const std::size_t mine = told_count_;
  heard_.wait(lock, [&] { return given_up_ || heard_count_ >= mine; });
  if (given_up_) throw GivenUp{};
}

void Watch::hear(const Message& message) {
  try {
    message();
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  } catch (const py::error_already_set& error) {
    if (!stoppable_ || interrupted_ || !error.matches(PyExc_KeyboardInterrupt)) throw;
    interrupted_ = true;
  }
}

void Watch::give_up() {
  const std::lock_guard lock(mutex_);
  given_up_ = true;
  heard_.notify_one();
}

void add_background() {
  // At the interpreter's end, so that it runs before the destructors of whatever was made until then.
  py::module_::import("atexit").attr("register")(
      py::cpp_function([] { static_cast<void>(on_exit(end_at_once, nullptr)); }));
}

void run_watched(std::function<void(Watch&)> work) {
  const auto watch = std::make_shared<Watch>();
  {
    const SignalsBlocked blocked;
    ++running;
    try {
      std::thread([watch, work = std::move(work)]() mutable {
        std::exception_ptr error;
        try {
          work(*watch);
        } catch (...) {
          error = std::current_exception();
        }
        work = nullptr;  // what it holds goes before anybody hears of its end
        {
          const std::lock_guard lock(watch->mutex_);
          watch->error_ = std::move(error);
          watch->done_ = true;
          watch->changed_.notify_one();
        }
        --running;
      }).detach();
    } catch (...) {
      --running;
      throw;
    }
  }
  try {
    for (bool done = false; !done;) {
      std::vector<Watch::Message> messages;
      PyThreadState* const others_may_run = PyEval_SaveThread();
      {
        std::unique_lock lock(watch->mutex_);
        watch->changed_.wait_for(lock, between_looks,
                                 [&] { return watch->done_ || !watch->messages_.empty(); });
        messages = std::exchange(watch->messages_, {});
        done = watch->done_;
      }
      take_gil_back(others_may_run);
      for (const Watch::Message& message : messages) watch->hear(message);
      watch->hear([] {});
      if (messages.empty()) continue;
      const std::lock_guard lock(watch->mutex_);
      watch->heard_count_ += messages.size();
      watch->heard_.notify_one();
    }
  } catch (...) {
    watch->give_up();
    throw;
  }
  if (watch->error_) std::rethrow_exception(std::exchange(watch->error_, nullptr));
}

}  // namespace bondstatic
