#pragma once

#include <algorithm>
#include <cmath>

namespace zona::mpm {

/// Isotropic elastodamage (5.9)-(5.11). The secant stiffness is E (1 + c_0 (exp(-c_1 omega) - 1)).
/// (5.10) prints 2 c_0, which contradicts the elastic limit that the source gives for a failure
/// strain of 0.06.
struct Elastodamage {
  double c0 = 10;                  ///< c_0 [-]
  double c1 = 10;                  ///< c_1 [-]
  double elastic_limit = 0.05937;  ///< S_L, the principal strain at which damage begins [-]

  /// omega of (5.11) [-] at this largest principal strain.
  double damage(double strain) const {
    return strain > elastic_limit ? strain / elastic_limit - 1 : 0;
  }
  /// Secant stiffness over elastic stiffness, in [0, 1]; zero means failed.
  double integrity(double damage) const {
    return std::max(0.0, 1 + c0 * (std::exp(-c1 * damage) - 1));
  }
  /// Principal strain at which the stiffness reaches zero [-].
  double failure_strain() const {
    return c0 > 1 ? elastic_limit * (1 - std::log(1 - 1 / c0) / c1) : HUGE_VAL;
  }
};

/// Throws ModelError for values out of range.
void check(const Elastodamage& model);

}  // namespace zona::mpm
