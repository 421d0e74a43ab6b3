#pragma once

#include <memory>

#include "beam/beam_system.h"
#include "beam/integrate.h"
#include "beam/march.h"
#include "beam/support_motion.h"

namespace zona::beam {

/// SUNDIALS ARKODE for `march`: y = (q, q'), steps adapted to the tolerances, ending on every
/// sample and kink.
/// Keeps references to the system and the motion; SUNDIALS stays out of this header.
class ArkodeStepper {
 public:
  ArkodeStepper(const BeamSystem& system, const SupportMotion& motion, const Arkode& options);
  ~ArkodeStepper();

  void advance(double from, double to);
  void kick(double time, double velocity_jump);
  RelativeMotion observed() const;

  /// Steps taken so far.
  long steps() const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace zona::beam
