#include "app/interrupt.hpp"

#include <signal.h>
#include <unistd.h>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

volatile sig_atomic_t deferred = 0;
volatile sig_atomic_t waiting_signal = 0;

void on_signal(int signal) {
  if (!deferred) _exit(128 + signal);
  waiting_signal = signal;
}

}  // namespace

void handle_interrupts() {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
  }
}

DeferredInterrupts::DeferredInterrupts() {
  deferred = deferred + 1;
}

DeferredInterrupts::~DeferredInterrupts() {
  deferred = deferred - 1;
  if (!deferred && waiting_signal) _exit(128 + waiting_signal);
}

bool DeferredInterrupts::waiting() {
  return waiting_signal != 0;
}

void DeferredInterrupts::check() {
  if (waiting_signal == SIGINT) throw Error(ExitCode::interrupted, "interrupted");
  if (waiting_signal == SIGTERM) throw Error(ExitCode::terminated, "terminated");
}

}  // namespace bondstatic
