#pragma once

#include <memory>

#include "beam/motion/support_motion.h"
#include "beam/system/beam_system.h"
#include "beam/system/transient_beam.h"
#include "beam/time/integrate.h"
#include "beam/time/march.h"

namespace zona::beam {

/// SUNDIALS ARKODE for `march`: the state of ArkodeEquations, steps adapted to the tolerances,
/// ending on every sample and kink.
/// Keeps a reference to the motion; SUNDIALS stays out of this header.
class ArkodeStepper {
 public:
  /// A beam at rest at t = 0. Throws std::runtime_error if SUNDIALS cannot be set up.
  ArkodeStepper(const BeamSystem& system, const SupportMotion& motion, const Arkode& options,
                const FrequencySpan& span);
  ~ArkodeStepper();

  /// @{
  /// What `march` asks of a stepper: goes from one instant to another [s]; changes the velocity at
  /// a kink where the support's jumps by `velocity_jump` [m/s]; tells the motion of the observed
  /// point. Throws std::runtime_error with the time reached when ARKODE gives up.
  void advance(double from, double to);
  void kick(double time, double velocity_jump);
  RelativeMotion observed() const;
  /// @}

  /// Steps taken so far.
  long steps() const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace zona::beam
