#pragma once

#include "mpm/material_points.h"
#include "mpm/velocity_gradient.h"

namespace zona::mpm {

struct ElasticProperties {
  double density;         ///< initial [kg/m^3]
  double youngs_modulus;  ///< E [Pa]
  double poisson_ratio;   ///< nu [-], below 0.5

  double lame_first() const {
    return youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
  }
  double shear_modulus() const { return youngs_modulus / (2 * (1 + poisson_ratio)); }
};

/// Isotropic linear elastic solid in rate form (3.41)-(3.42). The stress is turned with the
/// material by the Jaumann rate, which the source omits: without it a turning body would make
/// stress.
struct LinearElastic {
  static constexpr bool has_stress = true;

  LinearElastic(const ElasticProperties& properties, int points);

  ElasticProperties properties;
  Field density;                ///< [kg/m^3]
  SymmetricTensorField stress;  ///< Cauchy [Pa]

  /// Primary wave (5.46) [m/s].
  double wave_speed() const {
    return std::sqrt((properties.lame_first() + 2 * properties.shear_modulus()) /
                     properties.density);
  }
  /// Secondary wave (5.47) [m/s].
  double shear_wave_speed() const {
    return std::sqrt(properties.shear_modulus() / properties.density);
  }
  Lanes volume(const PointGroup& group, const Lanes& mass) const {
    return mass / group.load(density);
  }
  LaneMask update(const PointGroup& group, const VelocityGradient& gradient, double dt,
                  double length);

  template <class F>
  void for_each_field(F f) {
    f(density);
    for (auto& component : stress) f(component);
  }
};

inline LaneMask LinearElastic::update(const PointGroup& group, const VelocityGradient& gradient,
                                      double dt, double) {
  const double lambda = properties.lame_first();
  const double two_g = 2 * properties.shear_modulus();
  const SymmetricTensorLanes rate = strain_rate(gradient);
  const SymmetricTensorLanes s = group.load(stress);
  // Spin (dv_i/dx_j - dv_j/dx_i)/2; the Jaumann rate adds W s - s W.
  const Lanes wxy = 0.5 * (gradient[0][1] - gradient[1][0]);
  const Lanes wyz = 0.5 * (gradient[1][2] - gradient[2][1]);
  const Lanes wzx = 0.5 * (gradient[2][0] - gradient[0][2]);
  const SymmetricTensorLanes turned{2.0 * (wxy * s[3] - wzx * s[5]),
                                    2.0 * (wyz * s[4] - wxy * s[3]),
                                    2.0 * (wzx * s[5] - wyz * s[4]),
                                    wxy * (s[1] - s[0]) + wyz * s[5] - wzx * s[4],
                                    wyz * (s[2] - s[1]) + wzx * s[3] - wxy * s[5],
                                    wzx * (s[0] - s[2]) + wxy * s[4] - wyz * s[3]};
  const Lanes spherical = lambda * trace(rate);
  SymmetricTensorLanes result;
  for (int c = 0; c < 6; ++c) {
    result[c] = s[c] + dt * (two_g * rate[c] + turned[c] + (c < 3 ? spherical : Lanes{}));
  }
  const Lanes new_density = group.load(density) / (1.0 + dt * trace(rate));
  group.store(density, new_density);
  group.store(stress, result);
  return ~((new_density > 0.0) & (new_density < HUGE_VAL));
}

}  // namespace zona::mpm
