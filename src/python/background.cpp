#include "python/background.hpp"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <utility>

namespace bondstatic {

namespace {

constexpr auto between_looks = std::chrono::milliseconds(50);

std::atomic<int> running = 0;

/// Static objects must not be destroyed under work that goes on unheard. Runs before their destructors, as it
/// is registered after them.
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

}  // namespace

void Watch::tell(Message message) {
  if (given_up_) throw GivenUp{};
  const std::lock_guard lock(mutex_);
  messages_.push_back(std::move(message));
  changed_.notify_one();
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
      {
        const py::gil_scoped_release others_may_run;
        std::unique_lock lock(watch->mutex_);
        watch->changed_.wait_for(lock, between_looks,
                                 [&] { return watch->done_ || !watch->messages_.empty(); });
        messages = std::exchange(watch->messages_, {});
        done = watch->done_;
      }
      for (const Watch::Message& message : messages) message();
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
  } catch (...) {
    static const int registered = on_exit(end_at_once, nullptr);
    static_cast<void>(registered);
    watch->given_up_ = true;
    throw;
  }
  if (watch->error_) std::rethrow_exception(std::exchange(watch->error_, nullptr));
}

}  // namespace bondstatic
