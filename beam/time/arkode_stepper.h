#pragma once

#include <memory>

#include "beam/motion/support_motion.h"
#include "beam/system/beam_system.h"
#include "beam/system/transient_beam.h"
#include "beam/time/integrate.h"
#include "beam/time/march.h"

namespace zona::beam {

/// Stepper for `march` by SUNDIALS ARKODE. It integrates ArkodeEquations with adaptive steps that
/// end on every sample and kink. Keeps a reference to the motion. This header does not need
/// SUNDIALS.
class ArkodeStepper {
 public:
  /// Starts at rest at t = 0. Throws std::runtime_error if SUNDIALS cannot be set up.
  ArkodeStepper(const BeamSystem& system, const SupportMotion& motion, const Arkode& options,
                const FrequencySpan& span);
  ~ArkodeStepper();

  /// @{
  /// Interface for `march`: advance from one instant to another [s]; apply a kink of the support,
  /// whose velocity jumps by `velocity_jump` [m/s]; return the motion of the observed point. Throw
  /// std::runtime_error with the time reached if ARKODE fails.
  void advance(double from, double to);
  void kick(double time, double velocity_jump);
  RelativeMotion observed() const;
  /// @}

  /// Number of steps taken.
  long steps() const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace zona::beam
