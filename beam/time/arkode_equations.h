#pragma once

#include <Eigen/Core>

#include "beam/motion/support_motion.h"
#include "beam/system/beam_system.h"
#include "beam/system/transient_beam.h"
#include "beam/time/march.h"

namespace zona::beam {

/// TransientBeam as a first-order system with the state (q, v, y_1, ..., y_J, z). Solves the Newton
/// matrix I - gamma J (without the quadratic drag) by one banded factorisation of the beam's size.
class ArkodeEquations {
 public:
  /// A vector that SUNDIALS owns.
  using View = Eigen::Map<Eigen::VectorXd>;

  /// Keeps a reference to the motion. Throws std::invalid_argument if the mass is not positive
  /// definite.
  ArkodeEquations(const BeamSystem& system, const SupportMotion& motion, const FrequencySpan& span);
  ArkodeEquations(const ArkodeEquations&) = delete;
  ArkodeEquations& operator=(const ArkodeEquations&) = delete;

  int state_size() const { return (2 + memories_) * size_ + memories_; }  ///< number of unknowns
  bool is_linear() const { return !drag_.acts(); }     ///< true without quadratic drag
  const TransientBeam& beam() const { return beam_; }  ///< the integrated beam

  /// rates = state' at this time.
  void rates(double time, const View& state, View rates);

  /// solution = (I - gamma J)^-1 right_side; factorises only if gamma has changed.
  void solve_newton(double gamma, const View& right_side, View solution);

  /// Applies a kink of g to the state: v -= M^-1 m velocity_jump.
  void kick(double velocity_jump, View state);

  /// Motion of the observed point relative to the support, in the state at `time` [s].
  RelativeMotion observed(double time, const View& state);

 private:
  TransientBeam beam_;
  int size_;
  int memories_;
  Eigen::VectorXd observation_;
  const SupportMotion& motion_;
  SupportVelocity support_velocity_;
  QuadraticDrag drag_;
  BandFactor mass_factor_;
  Eigen::VectorXd kick_;
  double gamma_ = 0;
  SymmetricBand operator_;
  BandFactor operator_factor_;
  Eigen::VectorXd displacement_, velocity_, acceleration_, product_, remembered_;
};

}  // namespace zona::beam
