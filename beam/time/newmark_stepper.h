#pragma once

#include <Eigen/Core>

#include "beam/algebra/symmetric_band.h"
#include "beam/motion/support_motion.h"
#include "beam/system/beam_system.h"
#include "beam/system/transient_beam.h"
#include "beam/time/integrate.h"
#include "beam/time/march.h"

namespace zona::beam {

/// Newmark's average-acceleration method for `march`. Memories of Maxwell elements are exact for
/// velocities that change linearly in a step; a quadratic drag is taken at predicted velocities.
/// Keeps a reference to the motion.
class NewmarkStepper {
 public:
  /// `step` [s] is the greatest step; a shorter span is cut into equal steps no longer than that.
  /// The lowest and highest frequencies that matter are `span`'s.
  NewmarkStepper(const BeamSystem& system, const SupportMotion& motion, double step,
                 const FrequencySpan& span = {1, 1e7});
  NewmarkStepper(const NewmarkStepper&) = delete;
  NewmarkStepper& operator=(const NewmarkStepper&) = delete;

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
  /// Adds the quadratic drag, its speed taken from a velocity, to the operator.
  void include_drag(const Eigen::VectorXd& velocity);
  /// -m g'' - C v - K q - memories [N], [N m], without the quadratic drag.
  void compute_force(double time, const Eigen::VectorXd& displacement,
                     const Eigen::VectorXd& velocity, Eigen::VectorXd& force);
  /// The acceleration now, by M alone: at the start and after a kick.
  void settle(double time);
  /// Memories at the end of a step at which the velocity is `velocity`.
  void advance_memories(double support_velocity, const Eigen::VectorXd& velocity);

  TransientBeam beam_;
  Eigen::VectorXd observation_;
  const SupportMotion& motion_;
  double greatest_step_;
  double step_ = 0;
  SupportVelocity support_velocity_;
  QuadraticDrag drag_;
  Eigen::ArrayXd kept_, from_old_, from_new_;  ///< of a memory and of both velocities in a step
  Eigen::MatrixXd memory_;                     ///< y_j, a column each
  Eigen::ArrayXd support_memory_;              ///< z_j
  SymmetricBand operator_;  ///< M + h/2 C + h^2/4 K and the share of memories, without drag
  BandFactor operator_factor_;
  BandFactor mass_factor_;
  Eigen::VectorXd kick_;  ///< M^-1 m
  Eigen::VectorXd displacement_, velocity_, acceleration_;
  Eigen::VectorXd predicted_, remembered_, product_;
};

}  // namespace zona::beam
