#pragma once

#include <Eigen/Core>

#include "beam/algebra/symmetric_band.h"
#include "beam/motion/support_motion.h"
#include "beam/system/beam_system.h"
#include "beam/system/transient_beam.h"
#include "beam/time/integrate.h"
#include "beam/time/march.h"

namespace zona::beam {

/// Stepper for `march` by Newmark's average-acceleration method. The memory variables of Maxwell
/// elements are exact for velocities that vary linearly in a step; the quadratic drag uses
/// predicted velocities. Keeps a reference to the motion.
class NewmarkStepper {
 public:
  /// `step` [s] is the longest step; spans are divided into equal steps of at most this length.
  /// `span` is the range of frequencies for the Maxwell elements.
  NewmarkStepper(const BeamSystem& system, const SupportMotion& motion, double step,
                 const FrequencySpan& span = {1, 1e7});
  NewmarkStepper(const NewmarkStepper&) = delete;
  NewmarkStepper& operator=(const NewmarkStepper&) = delete;

  /// @{
  /// Interface for `march`: advance from one instant to another [s]; apply a kink of the support,
  /// whose velocity jumps by `velocity_jump` [m/s]; return the motion of the observed point.
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
  /// Adds the quadratic drag at the speeds of a velocity to the operator.
  void include_drag(const Eigen::VectorXd& velocity);
  /// -m g'' - C v - K q - memories [N], [N m], without the quadratic drag.
  void compute_force(double time, const Eigen::VectorXd& displacement,
                     const Eigen::VectorXd& velocity, Eigen::VectorXd& force);
  /// Computes the acceleration from the current state, at the start and after a kick.
  void compute_acceleration(double time);
  /// Advances the memory variables to the end of a step, where the velocity is `velocity`.
  void advance_memories(double support_velocity, const Eigen::VectorXd& velocity);

  TransientBeam beam_;
  Eigen::VectorXd observation_;
  const SupportMotion& motion_;
  double greatest_step_;
  double step_ = 0;
  SupportVelocity support_velocity_;
  QuadraticDrag drag_;
  Eigen::ArrayXd kept_, from_old_,
      from_new_;                   ///< factors of memory, old and new velocity in a step
  Eigen::MatrixXd memory_;         ///< y_j, a column each
  Eigen::ArrayXd support_memory_;  ///< z_j
  SymmetricBand
      operator_;  ///< M + h/2 C + h^2/4 K and the share of memories, without quadratic drag
  BandFactor operator_factor_;
  BandFactor mass_factor_;
  Eigen::VectorXd kick_;  ///< M^-1 m
  Eigen::VectorXd displacement_, velocity_, acceleration_;
  Eigen::VectorXd predicted_, remembered_, product_;
};

}  // namespace zona::beam
