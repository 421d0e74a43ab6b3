#pragma once

#include <string>
#include <vector>

#include "mpm/bodies/body.h"

namespace zona::mpm {

/// The largest stable step and what sets it.
struct CriticalStep {
  double seconds;      ///< [s]; infinite if nothing limits it
  std::string body;    ///< which sets it
  std::string reason;  ///< what of the body does, for a message
};

/// Smallest over all bodies of h / c, where h is the shortest cell edge and c the wave speed, and
/// of the explicit limit of the viscous terms, rho h^2 / (8 mu). Bodies that move as prescribed
/// have no wave speed.
///
/// For quadratic functions sqrt(2/3) h takes the place of h. Inside the grid they would allow
/// 1.63 h / c; the functions at an open end have a third of a cell's mass and a largest eigenvalue
/// of 6 c^2 / h^2 where linear ones have 4. On absorbing faces the tractions lower what is stable
/// to 0.9 of this step, for either interpolation.
CriticalStep critical_step(const BackgroundGrid& grid, const std::vector<Body>& bodies);

}  // namespace zona::mpm
