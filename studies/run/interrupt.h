#pragma once

#include <csignal>

namespace zona::studies {

/// While it lives, the first SIGINT (Ctrl-C) or SIGTERM only raises a flag, so that a run stops at
/// its next step and writes what it has; the second ends the program at once.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// The run should stop. Cheap enough to ask every step, from any thread.
  static bool requested();

 private:
  struct sigaction old_interrupt_;
  struct sigaction old_terminate_;
};

}  // namespace zona::studies
