#pragma once

#include <variant>

#include "beam/motion/sampling.h"
#include "beam/motion/support_motion.h"
#include "beam/motion/tip_history.h"
#include "beam/system/beam_system.h"

/// The pipette as a vibrating beam: sections, support motions, finite elements, integrators in
/// time, and exact solutions to check them against. Knows nothing of material points.
namespace zona::beam {

/// Newmark's method with average acceleration (beta 1/4, gamma 1/2): second order, unconditionally
/// stable, conserves the energy of an undamped beam. The dissertation's choice, at 0.6 us.
struct Newmark {
  int steps_per_sample = 1;  ///< equal steps from sample to sample
};

/// Modal superposition, exact in time for any support motion here, with or without Rayleigh
/// damping, and in a bath of BathModel::per_mode. A fluid in the bore of a rod acts on each mode as
/// at the mode's own frequency.
struct Modal {
  int modes = 0;  ///< the lowest ones are kept; 0 keeps all
};

/// Which Runge-Kutta family ARKODE uses. Every mode rings undamped, so accuracy and stability ask
/// for steps of the same size and the explicit family wins; stiffness-proportional damping makes
/// the beam truly stiff and calls for the implicit one.
enum class RungeKutta {
  explicit_8,  ///< Fehlberg 13(7, 8)
  implicit_5,  ///< ESDIRK of order 5(4), stiffly accurate and L-stable
};

/// SUNDIALS ARKODE with adaptive steps that end on the kinks of the support motion.
struct Arkode {
  double relative_tolerance = 1e-6;  ///< of every component of the state [-]
  /// Of displacements [m]. Of rotations it is divided by the element length, of velocities by the
  /// time in which the support covers its peak displacement at its peak speed.
  double absolute_tolerance = 1e-11;
  RungeKutta method = RungeKutta::explicit_8;  ///< family of Runge-Kutta methods
};

/// By the inverse Laplace transform of the beam's transfer function (`integrate_by_transform`): the
/// bath has its load at every frequency, without Maxwell elements.
struct Transform {};

/// How the equations are integrated in time, with its parameters.
using Integrator = std::variant<Newmark, Modal, Arkode, Transform>;

/// Motion of the observed point of a beam at rest whose support begins to move at t = 0. Velocities
/// at a kink are those just after it; accelerations leave the impulses at the kinks out. Throws
/// std::invalid_argument for a bad motion, sampling or integrator, and std::runtime_error, with the
/// time reached, if ARKODE gives up.
TipHistory integrate(const BeamSystem& system, const SupportMotion& motion,
                     const Sampling& sampling, const Integrator& integrator);

}  // namespace zona::beam
