#pragma once

#include <string>
#include <vector>

#include "mpm/body.h"

namespace zona::mpm {

/// The largest stable step and what sets it.
struct CriticalStep {
  double seconds;
  std::string body;
  std::string reason;
};

/// Smallest over all bodies of h / c, where h is the shortest cell edge and c the wave speed, and
/// of the explicit limit of the viscous terms, rho h^2 / (8 mu). Absorbing tractions allow 2 h / c
/// and never decide. Bodies that move as prescribed have no wave speed.
CriticalStep critical_step(const BackgroundGrid& grid, const std::vector<Body>& bodies);

}  // namespace zona::mpm
