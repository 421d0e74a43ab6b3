#pragma once

#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

/// Ratio of the reflected to the incident pressure when a plane sound wave meets a boundary whose
/// only traction is the normal one p = beta rho c v_n (Lysmer and Kuhlemeyer 1969; beta = 1 is the
/// viscous boundary) at `angle` [rad] from the normal.
///
/// A plane wave at that angle has p/v_n = rho c/cos(angle). With the impedance beta rho c of the
/// boundary, pressure 1 + R and normal velocity (1 - R) cos(angle)/(rho c) on it give
///   R = (beta cos(angle) - 1)/(beta cos(angle) + 1),
/// so that |R| = (1 - cos)/(1 + cos) for beta = 1: 0 at normal, 3 % at 20 degrees, 17 % at 45, all
/// at grazing incidence. The normal velocity is reflected with -R. Damping of the
/// tangential motion changes nothing in a fluid without viscosity. Throws ModelError for angles
/// outside [0, pi/2] and a negative beta.
inline double reflected_pressure(double angle, double beta = 1) {
  require(angle >= 0 && angle <= 1.5707963267948968,
          "the angle of incidence is in [0, pi/2], not " + std::to_string(angle));
  require(beta >= 0, "the damping of a boundary is not negative");
  const double matched = beta * std::cos(angle);
  return (matched - 1) / (matched + 1);
}

}  // namespace zona::studies::references
