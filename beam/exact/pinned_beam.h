#pragma once

#include "beam/motion/support_motion.h"
#include "beam/pipette/section.h"

namespace zona::beam {

/// Treatment of the velocity A w that the sine gives the support at t = 0.
enum class SupportStart {
  as_printed,  ///< omitted, as in (5.74); the left end then starts with a wrong velocity
  complete,    ///< included: the relative motion starts with the velocity -(1 - x/l) A w
};

/// Uniform simply supported beam whose left end moves as g1(t) = A sin(w t) from rest at t = 0,
/// with a fixed right end (Figures 5.25 and 5.26).
struct ExactPinnedBeam {
  UniformBeam beam;    ///< its section
  SineMotion support;  ///< motion of the left end
  int modes = 200;     ///< number of modes in the sum

  /// omega_i = (i pi / l)^2 c [rad/s]; modes count from 1.
  double angular_frequency(int mode) const;

  /// Absolute deflection v(x, t) [m] by (5.73)-(5.75), with the factor 2/l that (5.74) lacks. The
  /// truncation error falls as 1/modes^2 or faster.
  double deflection(double x, double time, SupportStart start) const;
};

}  // namespace zona::beam
