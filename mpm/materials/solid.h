#pragma once

#include "mpm/materials/elastic_moduli.h"
#include "mpm/points/material_points.h"
#include "mpm/points/velocity_gradient.h"

namespace zona::mpm {

/// Constants of an isotropic elastic solid.
struct ElasticProperties {
  double density;         ///< initial [kg/m^3]
  double youngs_modulus;  ///< E [Pa]
  double poisson_ratio;   ///< nu [-], below 0.5

  /// The elastic moduli.
  ElasticModuli moduli() const { return {youngs_modulus, poisson_ratio}; }
};

/// Throws ModelError for values out of range.
void check(const ElasticProperties& properties);

/// The law of a linear elastic material.
struct Elastic {};

/// State of a solid's points under a law, and the law's limit on the stress. A state has
///     SolidState(const Law&, int points);                    throws ModelError
///     SymmetricTensorField& elastic_stress(stress);          the tensor that Hooke's law advances
///     SymmetricTensorLanes limit(group, trial, gradient, dt, properties, law);  Cauchy stress
///     for_each_field(f);
template <class Law>
struct SolidState;

/// Linear elasticity: no state, no limit.
template <>
struct SolidState<Elastic> {
  /// See SolidState.
  SolidState(const Elastic&, int) {}
  /// The stress itself.
  SymmetricTensorField& elastic_stress(SymmetricTensorField& stress) { return stress; }
  /// The trial stress [Pa].
  SymmetricTensorLanes limit(const PointGroup&, const SymmetricTensorLanes& trial,
                             const VelocityGradient&, double, const ElasticProperties&,
                             const Elastic&) {
    return trial;
  }
  /// No fields.
  template <class F>
  void for_each_field(F) {}
};

/// Isotropic solid in rate form (3.41)-(3.42): Hooke's law, then the limit that its law (Elastic,
/// VonMises, Elastodamage) sets to the stress. The Jaumann rate rotates the stress with the
/// material; the source omits it, but without it a rotating body would gain stress.
template <class Law>
struct Solid {
  /// Its points contribute internal forces.
  static constexpr bool has_stress = true;

  /// Points without stress. Throws ModelError.
  Solid(const ElasticProperties& properties, int points, const Law& law = {});

  ElasticProperties properties;  ///< constants of all points
  Law law;                       ///< limits the stress
  Field density;                 ///< [kg/m^3]
  SymmetricTensorField stress;   ///< Cauchy [Pa]
  SolidState<Law> state;         ///< of the law, per point

  /// Primary wave speed (5.46) [m/s].
  double wave_speed() const {
    return std::sqrt(properties.moduli().constrained() / properties.density);
  }
  /// Secondary wave speed (5.47) [m/s].
  double shear_wave_speed() const {
    return std::sqrt(properties.moduli().shear() / properties.density);
  }
  /// Current volume [m^3] of a group of this mass [kg].
  Lanes volume(const PointGroup& group, const Lanes& mass) const {
    return mass / group.load(density);
  }
  /// Advances density and stress (3.41)-(3.42) by dt [s] at a velocity gradient [1/s]; does not use
  /// `length`. Returns a mask of the points whose density is no longer positive.
  LaneMask update(const PointGroup& group, const VelocityGradient& gradient, double dt,
                  double length);

  /// Calls f(Field) for each field that a step changes.
  template <class F>
  void for_each_field(F f) {
    f(density);
    for (auto& component : stress) f(component);
    state.for_each_field(f);
  }
};

/// A linear elastic solid.
using LinearElastic = Solid<Elastic>;

/// Stress [Pa] after a step of dt [s] from the stress `s`, by Hooke's law and the Jaumann rate.
inline SymmetricTensorLanes elastic_step(const SymmetricTensorLanes& s,
                                         const VelocityGradient& gradient,
                                         const SymmetricTensorLanes& rate,
                                         const ElasticModuli& moduli, double dt) {
  const double two_g = 2 * moduli.shear();
  const Lanes spherical = moduli.lame_first() * trace(rate);
  const SymmetricTensorLanes turned = turning_rate(gradient, s);
  SymmetricTensorLanes result;
  for (int c = 0; c < 6; ++c) {
    result[c] = s[c] + dt * (two_g * rate[c] + turned[c] + (c < 3 ? spherical : Lanes{}));
  }
  return result;
}

template <class Law>
inline LaneMask Solid<Law>::update(const PointGroup& group, const VelocityGradient& gradient,
                                   double dt, double) {
  const SymmetricTensorLanes rate = strain_rate(gradient);
  SymmetricTensorField& driven = state.elastic_stress(stress);
  const SymmetricTensorLanes trial =
      elastic_step(group.load(driven), gradient, rate, properties.moduli(), dt);
  const Lanes new_density = group.load(density) / (1.0 + dt * trace(rate));
  group.store(density, new_density);
  if (&driven != &stress) group.store(driven, trial);
  group.store(stress, state.limit(group, trial, gradient, dt, properties, law));
  return ~((new_density > 0.0) & (new_density < HUGE_VAL));
}

template <class Law>
Solid<Law>::Solid(const ElasticProperties& p, int points, const Law& l)
    : properties(p), law(l), density(points, p.density), state(l, points) {
  check(p);
  for (auto& component : stress) component.assign(points, 0.0);
}

/// True if a material is a solid in three dimensions, with any law.
template <class Material>
inline constexpr bool is_solid = false;
/// The case of a solid.
template <class Law>
inline constexpr bool is_solid<Solid<Law>> = true;

}  // namespace zona::mpm
