#pragma once

namespace zona::studies {

/// While it lives, the first SIGINT (Ctrl-C) or SIGTERM only raises a flag, so that a run stops at
/// its next step and writes what it has; the second ends the program at once. Runs side by side may
/// each hold one: the first takes the signals over, the last gives them back.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// The run should stop. Cheap enough to ask every step, from any thread.
  static bool requested();
};

}  // namespace zona::studies
