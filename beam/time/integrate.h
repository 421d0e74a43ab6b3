#pragma once

#include <variant>

#include "beam/motion/sampling.h"
#include "beam/motion/support_motion.h"
#include "beam/motion/tip_history.h"
#include "beam/system/beam_system.h"

/// The pipette as a vibrating beam: sections, support motions, finite elements, time integration,
/// frequency response and exact solutions. Independent of material points.
namespace zona::beam {

/// Newmark's method with average acceleration (beta 1/4, gamma 1/2): second order, unconditionally
/// stable, conserves the energy of an undamped beam. The source uses it with steps of 0.6 us.
struct Newmark {
  int steps_per_sample = 1;  ///< equal steps from sample to sample
};

/// Modal superposition: exact in time for any SupportMotion, with or without Rayleigh damping, and
/// in a bath of BathModel::per_mode. The load of a fluid in the bore of a rod is that at each
/// mode's own frequency.
struct Modal {
  int modes = 0;  ///< number of lowest modes to use; 0 for all
};

/// Runge-Kutta family of ARKODE. Undamped modes need steps of the same size for accuracy and for
/// stability, so the explicit family is faster; stiffness-proportional damping makes the beam stiff
/// and needs the implicit one.
enum class RungeKutta {
  explicit_8,  ///< Fehlberg 13(7, 8)
  implicit_5,  ///< ESDIRK of order 5(4), stiffly accurate and L-stable
};

/// SUNDIALS ARKODE with adaptive steps that end on the kinks of the support motion.
struct Arkode {
  double relative_tolerance = 1e-6;  ///< of every component of the state [-]
  /// Tolerance of displacements [m]. For rotations it is divided by the element length, for
  /// velocities by the time in which the support covers its peak displacement at its peak speed.
  double absolute_tolerance = 1e-11;
  RungeKutta method = RungeKutta::explicit_8;  ///< family of Runge-Kutta methods
};

/// Inverse Laplace transform of the beam's transfer function (`integrate_by_transform`), with the
/// exact load of the bath at every frequency.
struct Transform {};

/// A method of time integration with its parameters.
using Integrator = std::variant<Newmark, Modal, Arkode, Transform>;

/// Motion of the observed point of a beam at rest whose support starts to move at t = 0. Velocities
/// at a kink are those just after it; accelerations do not contain the impulses at kinks. Throws
/// std::invalid_argument for an invalid motion, sampling or integrator, and std::runtime_error with
/// the time reached if ARKODE fails.
TipHistory integrate(const BeamSystem& system, const SupportMotion& motion,
                     const Sampling& sampling, const Integrator& integrator);

}  // namespace zona::beam
