#pragma once

namespace zona::mpm {

/// Isotropic linear elasticity.
struct ElasticModuli {
  double youngs_modulus;  ///< E [Pa]
  double poisson_ratio;   ///< nu [-], above -1; below 0.5, in plane stress below 1

  /// First Lame parameter lambda [Pa].
  double lame_first() const {
    return youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
  }
  /// Shear modulus G [Pa].
  double shear() const { return youngs_modulus / (2 * (1 + poisson_ratio)); }
  /// Bulk modulus K [Pa].
  double bulk() const { return youngs_modulus / (3 * (1 - 2 * poisson_ratio)); }
  /// Constrained modulus lambda + 2 G [Pa], for strain in one direction only.
  double constrained() const { return lame_first() + 2 * shear(); }
  /// Constrained modulus in plane stress, E / (1 - nu^2) [Pa].
  double plane_stress() const { return youngs_modulus / (1 - poisson_ratio * poisson_ratio); }
};

}  // namespace zona::mpm
