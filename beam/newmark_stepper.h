#pragma once

#include <Eigen/Core>

#include "beam/beam_system.h"
#include "beam/integrate.h"
#include "beam/march.h"
#include "beam/support_motion.h"
#include "beam/symmetric_band.h"

namespace zona::beam {

/// Newmark's average-acceleration method for `march`. Keeps references to the system and the
/// motion.
class NewmarkStepper {
 public:
  /// `step` [s] is the greatest step; a shorter span is cut into equal steps no longer than that.
  NewmarkStepper(const BeamSystem& system, const SupportMotion& motion, double step);

  /// @{
  /// What `march` asks of a stepper: goes from one instant to another [s]; changes the velocity at
  /// a kink where the support's jumps by `velocity_jump` [m/s]; tells the motion of the observed
  /// point.
  void advance(double from, double to);
  void kick(double time, double velocity_jump);
  RelativeMotion observed() const;
  /// @}

  /// (v.M v + q.K q) / 2 of the relative motion [J].
  double energy() const;

  /// Starts from given relative displacements and velocities instead of rest.
  void set_state(double time, const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity);

 private:
  void factorise(double step);
  void step_to(double time);
  /// Solves (M or the factorised operator) x = -m g'' - C velocity - K displacement into x.
  void solve_acceleration(const BandFactor& factor, double time,
                          const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity,
                          Eigen::VectorXd& acceleration);

  const BeamSystem& system_;
  const SupportMotion& motion_;
  double greatest_step_;
  double step_ = 0;
  SymmetricBand operator_;
  BandFactor operator_factor_;
  BandFactor mass_factor_;
  Eigen::VectorXd kick_;  ///< M^-1 m
  Eigen::VectorXd displacement_, velocity_, acceleration_;
  Eigen::VectorXd combined_, product_;
};

}  // namespace zona::beam
