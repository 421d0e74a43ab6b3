#pragma once

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

/// Isotropic elastodamage (5.9)-(5.11). The secant stiffness is E (1 + c_0 (exp(-c_1 omega) - 1)):
/// (5.10) prints 2 c_0, with which the elastic limit given for a failure strain of 0.06 does not
/// fit.
struct Elastodamage {
  double c0 = 10;
  double c1 = 10;
  double elastic_limit = 0.05937;  ///< S_L, the principal strain at which damage begins [-]

  /// omega of (5.11) at a largest principal strain.
  double damage(double strain) const {
    return strain > elastic_limit ? strain / elastic_limit - 1 : 0;
  }
  /// Secant stiffness over the elastic one, in [0, 1]; zero means failed.
  double integrity(double damage) const {
    return std::max(0.0, 1 + c0 * (std::exp(-c1 * damage) - 1));
  }
  /// The principal strain at which nothing is left of the stiffness [-].
  double failure_strain() const {
    return c0 > 1 ? elastic_limit * (1 - std::log(1 - 1 / c0) / c1) : HUGE_VAL;
  }
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
