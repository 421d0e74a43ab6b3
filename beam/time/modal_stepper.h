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
  Eigen::ArrayXd drag_participation{};  ///< modal drag per -g' [1/s]; empty: none
};

/// The lowest `count` modes under Rayleigh damping C = alpha M + beta K.
ModalOscillators oscillators(const NaturalModes& modes, int count, double alpha, double beta);

/// The lowest `count` modes of a beam. Half its loss factor is the damping ratio of each. Of
/// liquids, whatever their model, each mode has the added mass and the drag of its own frequency in
/// them, and what they couple modes by is left out; it is nothing for a cylinder immersed all over,
/// or filled all over. A quadratic drag is left out.
ModalOscillators oscillators(const BeamSystem& system, const NaturalModes& modes, int count);

/// Modal superposition for `march`: every mode is an oscillator solved exactly between kinks,
/// and a kink changes its velocity by -participation * jump. Keeps a reference to the motion.
class ModalStepper {
 public:
  /// Throws std::invalid_argument if a sine drives an undamped mode at its own frequency, where the
  /// response has no steady part.
  ModalStepper(ModalOscillators modes, const SupportMotion& motion, double sampling_step);

  /// @{
  /// What `march` asks of a stepper: goes from one instant to another [s]; changes the velocity at
  /// a kink where the support's jumps by `velocity_jump` [m/s]; tells the motion of the observed
  /// point.
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
  Eigen::ArrayXcd steady_;  ///< steady response is Im(steady exp(i w t)); empty if there is none
  double steady_frequency_ = 0;
  double support_velocity_ = 0;  ///< g' of a motion of straight pieces; 0 for a sine
  double time_ = 0;
  Eigen::ArrayXd displacement_, velocity_, previous_;
};

}  // namespace zona::beam
