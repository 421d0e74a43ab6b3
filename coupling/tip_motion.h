#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "beam/motion/tip_history.h"
#include "mpm/materials/rigid_motion.h"

/// From the motion of a pipette's tip, computed or measured, to the motion of a rigid body.
namespace zona::coupling {

/// Which part of a tip's history drives the pipette, and how.
struct TipMotionOptions {
  /// Instant of the history at which the pipette starts [s]; if absent, the instant at which the
  /// tip, in whatever direction, has first moved by `start_fraction` of its largest displacement
  /// (see `onset_of_motion`).
  std::optional<double> start;
  double start_fraction = 0.01;                     ///< in (0, 1)
  std::optional<double> length;                     ///< of the window [s]; absent: to the end
  double scale = 1;                                 ///< multiplies the displacement
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of any length but zero
  double ramp = 0;                                  ///< duration of the smooth start [s]
};

/// The history of a tip's displacement in a direction.
struct DirectedHistory {
  beam::TipHistory history;                         ///< of the displacement along `axis`
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of any length but zero
};

/// The motion of the MPM pipette that a tip history prescribes, or two of them with an axis each:
/// the motion is then their sum, over one window.
///
/// Between the samples the displacement is the cubic that has the sampled displacements and
/// velocities at both ends (Hermite): once continuously differentiable, its error of fourth order
/// in the sampling step if the velocities are exact, of third if they are `second_order_slopes`,
/// which are used when the history has none. With u(t) this interpolant, w the window's start and r
/// the `smooth_ramp`, at time t after the window's start
///
///     displacement = scale r(t) (u(w + t) - u(w)) axis,   velocity = its exact derivative.
///
/// So the pipette always starts where it stands. Its velocity at t = 0 is scale u'(w) without a
/// ramp, which is a jump from rest: small when the window starts before the tip moves, and
/// `initial_speed` says how large. A ramp removes the jump and leaves the motion after it
/// untouched.
class TipMotion {
 public:
  /// Throws `TraceError` if the history is inconsistent, `std::invalid_argument` if an option is
  /// out of range, `std::out_of_range` if the window is not within the history.
  TipMotion(const beam::TipHistory& history, const TipMotionOptions& options);
  /// With a second history beside that along `options.axis`.
  TipMotion(const beam::TipHistory& history, const TipMotionOptions& options,
            const DirectedHistory& second);

  /// State at `time` [s] after the window's start. Throws `std::out_of_range`, never extrapolates,
  /// outside the window (by more than a rounding error of 1e-9 of its length).
  mpm::RigidState operator()(double time) const;

  double start() const { return start_; }    ///< of the window, in the history's time [s]
  double length() const { return length_; }  ///< of the window [s]
  /// Of the first history, of length one.
  const Eigen::Vector3d& axis() const { return parts_.front().axis; }
  /// Speed along the axis at the window's start before any ramp [m/s]; of two histories the
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

/// The first instant [s] at which the interpolated displacement of a history has departed from its
/// first sample by `fraction` of the largest departure of any sample. Throws
/// `std::invalid_argument` if the fraction is not in (0, 1) or the tip never moves.
double onset_of_motion(const beam::TipHistory& history, double fraction);

}  // namespace zona::coupling
