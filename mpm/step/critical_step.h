#pragma once

#include <string>
#include <vector>

#include "mpm/bodies/body.h"

namespace zona::mpm {

/// The largest stable step and its cause.
struct CriticalStep {
  double seconds;      ///< [s]; infinite without a limit
  std::string body;    ///< name of the limiting body
  std::string reason;  ///< for a message
};

/// Minimum over all bodies of h / c, where h is the shortest cell edge and c the wave speed, and of
/// the explicit limit of the viscous terms, rho h^2 / (8 mu). Bodies with prescribed motion have no
/// wave speed.
///
/// For quadratic functions sqrt(2/3) h replaces h. Inside the grid they would allow 1.63 h / c, but
/// the functions at an open end have a third of a cell's mass and a largest eigenvalue of
/// 6 c^2 / h^2, where linear ones have 4. Tractions on absorbing faces lower the stable step to 0.9
/// of this one, for either interpolation.
CriticalStep critical_step(const BackgroundGrid& grid, const std::vector<Body>& bodies,
                           bool implicit_pressure = false);

}  // namespace zona::mpm
