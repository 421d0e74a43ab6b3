#pragma once

#include <Eigen/Core>

#include "beam/beam_system.h"
#include "beam/march.h"
#include "beam/support_motion.h"

namespace zona::beam {

/// The beam as the first-order system y = (q, v): q' = v, v' = M^-1 (-m g'' - C v - K q), with the
/// Newton matrix I - gamma J solved through one banded factorisation of the beam's own size.
class ArkodeEquations {
 public:
  /// A vector in memory of SUNDIALS.
  using View = Eigen::Map<Eigen::VectorXd>;

  /// Keeps references to both. Throws std::invalid_argument if the mass is not positive definite.
  ArkodeEquations(const BeamSystem& system, const SupportMotion& motion);

  /// rates = y' at this time.
  void rates(double time, const View& state, View rates);

  /// solution = (I - gamma J)^-1 right_side; factorises only when gamma has changed.
  void solve_newton(double gamma, const View& right_side, View solution);

  /// Jump of the state at a kink of g: v -= M^-1 m velocity_jump.
  void kick(double velocity_jump, View state) const;

  /// The observed point relative to the support in the state y at `time` [s].
  RelativeMotion observed(double time, const View& state);

 private:
  const BeamSystem& system_;
  const SupportMotion& motion_;
  BandFactor mass_factor_;
  Eigen::VectorXd kick_;
  double gamma_ = 0;
  SymmetricBand operator_;
  BandFactor operator_factor_;
  Eigen::VectorXd displacement_, velocity_, acceleration_, product_;
};

}  // namespace zona::beam
