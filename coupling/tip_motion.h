#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "beam/motion/tip_history.h"
#include "mpm/materials/rigid_motion.h"

/// Motion of a rigid body from the motion of a pipette's tip, computed or measured.
namespace zona::coupling {

/// The window of a tip's history that drives the pipette, and its transformation.
struct TipMotionOptions {
  /// Time in the history at which the pipette starts [s]. If absent, the time at which the tip has
  /// first moved, in any direction, by `start_fraction` of its largest displacement (see
  /// `onset_of_motion`).
  std::optional<double> start;
  double start_fraction = 0.01;                     ///< in (0, 1)
  std::optional<double> length;                     ///< of the window [s]; absent for the rest
  double scale = 1;                                 ///< factor of the displacement
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of any length except zero
  double ramp = 0;                                  ///< duration of the smooth start [s]
};

/// History of a tip's displacement along a direction.
struct DirectedHistory {
  beam::TipHistory history;                         ///< of the displacement along `axis`
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of any length except zero
};

/// Motion of the MPM pipette from a tip history along an axis, or the sum of two such motions over
/// one window.
///
/// Between samples the displacement is the cubic with the sampled displacements and velocities at
/// both ends (Hermite). It is once continuously differentiable; its error is of fourth order in the
/// sampling step if the velocities are exact, and of third order for `second_order_slopes`, which
/// replace missing velocities. With this interpolant u(t), the window's start w and the
/// `smooth_ramp` r, at time t after the window's start
///
///     displacement = scale r(t) (u(w + t) - u(w)) axis,   velocity = its exact derivative.
///
/// so the pipette starts at its place. Without a ramp its velocity jumps from rest to scale u'(w)
/// at t = 0 (see `initial_speed`); the jump is small if the window starts before the tip moves. A
/// ramp removes the jump and does not change the motion after it.
class TipMotion {
 public:
  /// Throws `TraceError` if the history is inconsistent, `std::invalid_argument` if an option is
  /// out of range, and `std::out_of_range` if the window is not within the history.
  TipMotion(const beam::TipHistory& history, const TipMotionOptions& options);
  /// Adds a second history to the one along `options.axis`.
  TipMotion(const beam::TipHistory& history, const TipMotionOptions& options,
            const DirectedHistory& second);

  /// State at `time` [s] after the window's start. Never extrapolates: throws `std::out_of_range`
  /// outside the window, with a tolerance of 1e-9 of its length.
  mpm::RigidState operator()(double time) const;

  double start() const { return start_; }    ///< of the window, in the history's time [s]
  double length() const { return length_; }  ///< of the window [s]
  /// Unit axis of the first history.
  const Eigen::Vector3d& axis() const { return parts_.front().axis; }
  /// Velocity along the axis at the window's start without ramp [m/s]; for two histories the
  /// magnitude of the velocity.
  double initial_speed() const;

 private:
  struct Part {
    beam::TipHistory history;
    Eigen::Vector3d axis;
    double offset;  ///< interpolated displacement at the window's start [m]
  };

  TipMotion(std::vector<DirectedHistory> histories, const TipMotionOptions& options);

  std::vector<Part> parts_;  ///< one per history
  double start_;
  double length_;
  double scale_;
  double ramp_;
};

/// First time [s] at which the interpolated displacement differs from the first sample by
/// `fraction` of the largest difference of any sample. Throws `std::invalid_argument` if the
/// fraction is not in (0, 1) or the tip never moves.
double onset_of_motion(const beam::TipHistory& history, double fraction);

}  // namespace zona::coupling
