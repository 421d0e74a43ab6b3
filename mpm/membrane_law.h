#pragma once

#include "mpm/elastodamage.h"
#include "mpm/material_points.h"

namespace zona::mpm {

/// What a membrane does where it would be compressed.
enum class OneWay {
  stress,  ///< taut, wrinkled (uniaxial stress) or slack, told apart by the principal stresses
  strain,  ///< as in 4.1: negative principal strains are zeroed before the plane-stress law
  off      ///< carries compression
};

struct MembraneProperties {
  double density;         ///< [kg/m^3]
  double thickness;       ///< [m]
  double youngs_modulus;  ///< E [Pa]
  double poisson_ratio;   ///< nu [-]
  OneWay one_way = OneWay::stress;
};

/// In-plane components of eight points: xx, yy, xy of the local tangent frame.
struct InPlane {
  Lanes xx, yy, xy;
};

/// Principal values, first >= second, and the direction of the first: cos and sin of twice its
/// angle.
struct Principal {
  Lanes first, second, cos2, sin2;
};

/// (4.22)-(4.24)
inline Principal principal(const InPlane& a) {
  const Lanes mean = 0.5 * (a.xx + a.yy);
  const Lanes half = 0.5 * (a.xx - a.yy);
  const Lanes radius = square_root(half * half + a.xy * a.xy);
  const LaneMask turned = radius > 0.0;
  const Lanes scale = 1.0 / (turned ? radius : broadcast(1));
  return {mean + radius, mean - radius, turned ? half * scale : broadcast(1), a.xy * scale};
}

/// Plane-stress elastic stress [Pa] (4.7)-(4.8) with the one-way law, at principal strains `e`.
inline InPlane membrane_stress(const Principal& e, const MembraneProperties& p) {
  const double plane_stress = p.youngs_modulus / (1 - p.poisson_ratio * p.poisson_ratio);
  const Lanes zero{};
  Lanes e1 = e.first;
  Lanes e2 = e.second;
  if (p.one_way == OneWay::strain) {
    e1 = larger(e1, zero);
    e2 = larger(e2, zero);
  }
  Lanes s1 = plane_stress * (e1 + p.poisson_ratio * e2);
  Lanes s2 = plane_stress * (e2 + p.poisson_ratio * e1);
  if (p.one_way == OneWay::stress) {
    const LaneMask wrinkled = s2 < 0.0;
    s1 = wrinkled ? larger(p.youngs_modulus * e1, zero) : s1;
    s2 = wrinkled ? zero : s2;
  }
  // (4.25)-(4.27)
  const Lanes mean = 0.5 * (s1 + s2);
  const Lanes radius = 0.5 * (s1 - s2);
  return {mean + radius * e.cos2, mean - radius * e.cos2, radius * e.sin2};
}

}  // namespace zona::mpm
