#pragma once

#include <Eigen/Core>

#include "beam/motion/support_motion.h"
#include "beam/system/natural_modes.h"
#include "beam/system/oscillator.h"
#include "beam/time/march.h"

namespace zona::beam {

/// The modes of a beam as independent oscillators: x'' + 2 sigma x' + omega^2 x = -participation
/// g'' - drag_participation g'.
struct ModalOscillators {
  Eigen::ArrayXd angular_frequency;     ///< omega [rad/s]
  Eigen::ArrayXd decay_rate;            ///< sigma [1/s]
  Eigen::ArrayXd participation;         ///< modal force per -g''
  Eigen::ArrayXd observed;              ///< the mode's shape at the observed point
  Eigen::ArrayXd drag_participation{};  ///< modal drag per -g' [1/s]; empty without drag
};

/// The lowest `count` modes under Rayleigh damping C = alpha M + beta K.
ModalOscillators oscillators(const NaturalModes& modes, int count, double alpha, double beta);

/// The lowest `count` modes of a beam, each with half the loss factor as its damping ratio.
/// Whatever the model of the liquids, each mode has their added mass and drag at its own frequency.
/// Neglects the coupling of modes by liquids, which vanishes for a cylinder immersed or filled over
/// its whole length, and the quadratic drag.
ModalOscillators oscillators(const BeamSystem& system, const NaturalModes& modes, int count);

/// Stepper for `march` by modal superposition: every mode is an oscillator with an exact solution
/// between kinks, and a kink changes its velocity by -participation * jump. Keeps a reference to
/// the motion.
class ModalStepper {
 public:
  /// Throws std::invalid_argument if a sine drives an undamped mode at its own frequency, where
  /// there is no steady response.
  ModalStepper(ModalOscillators modes, const SupportMotion& motion, double sampling_step);

  /// @{
  /// Interface for `march`: advance from one instant to another [s]; apply a kink of the support,
  /// whose velocity jumps by `velocity_jump` [m/s]; return the motion of the observed point.
  void advance(double from, double to);
  void kick(double time, double velocity_jump);
  RelativeMotion observed() const;
  /// @}

 private:
  void find_steady_response(const SineMotion& sine);
  void apply(const OscillatorTransition& span);
  void add_steady_response(double time, double sign);

  const SupportMotion& motion_;
  double sampling_step_;
  ModalOscillators modes_;
  OscillatorTransition sampling_transition_;
  Eigen::ArrayXcd steady_;  ///< steady response is Im(steady exp(i w t)); empty without a sine
  double steady_frequency_ = 0;
  double support_velocity_ = 0;  ///< g' of a motion of straight pieces; 0 for a sine
  double time_ = 0;
  Eigen::ArrayXd displacement_, velocity_, previous_;
};

}  // namespace zona::beam
