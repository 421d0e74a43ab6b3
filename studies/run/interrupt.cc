#include "studies/run/interrupt.h"

#include <atomic>
#include <csignal>
#include <mutex>

namespace zona::studies {

namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free,
              "a signal handler may only touch such a flag");

std::mutex mutex;  ///< of what follows
int holders = 0;
struct sigaction old_interrupt;
struct sigaction old_terminate;

extern "C" void request_stop(int) {
  stop_requested = true;
}

}  // namespace

Interrupt::Interrupt() {
  const std::lock_guard lock(mutex);
  if (holders++ > 0) return;
  stop_requested = false;
  struct sigaction action = {};
  action.sa_handler = request_stop;
  // SA_RESETHAND brings back the default for the second signal.
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &old_interrupt);
  sigaction(SIGTERM, &action, &old_terminate);
}

Interrupt::~Interrupt() {
  const std::lock_guard lock(mutex);
  if (--holders > 0) return;
  sigaction(SIGINT, &old_interrupt, nullptr);
  sigaction(SIGTERM, &old_terminate, nullptr);
}

bool Interrupt::requested() {
  return stop_requested.load(std::memory_order_relaxed);
}

}  // namespace zona::studies
