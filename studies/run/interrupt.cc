#include "studies/run/interrupt.h"

#include <atomic>

namespace zona::studies {

namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free,
              "a signal handler may only touch such a flag");

extern "C" void request_stop(int) {
  stop_requested = true;
}

}  // namespace

Interrupt::Interrupt() {
  stop_requested = false;
  struct sigaction action = {};
  action.sa_handler = request_stop;
  // SA_RESETHAND brings back the default for the second signal.
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &old_interrupt_);
  sigaction(SIGTERM, &action, &old_terminate_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &old_interrupt_, nullptr);
  sigaction(SIGTERM, &old_terminate_, nullptr);
}

bool Interrupt::requested() {
  return stop_requested.load(std::memory_order_relaxed);
}

}  // namespace zona::studies
