#pragma once

#include "mpm/materials/elastodamage.h"
#include "mpm/materials/solid.h"

namespace zona::mpm {

/// State of the points of a solid with elastodamage (5.9)-(5.11). The law needs total strains. They
/// are stored as the stress that the undamaged solid would have, which follows Hooke's law and the
/// Jaumann rate and is equivalent to the strain. The strain measure is that of the rate form, i.e.
/// the logarithmic strain if the principal axes do not rotate.
template <>
struct SolidState<Elastodamage> {
  /// Undamaged points. Throws ModelError.
  SolidState(const Elastodamage& law, int points);

  SymmetricTensorField effective_stress;  ///< of the undamaged solid [Pa]
  Field strain;     ///< largest principal strain so far; 0 until it exceeds S_L [-]
  Field integrity;  ///< secant over elastic stiffness; 0 = failed [-]

  /// The effective stress.
  SymmetricTensorField& elastic_stress(SymmetricTensorField&) { return effective_stress; }
  /// Updates the damage and returns the trial stress times the integrity [Pa].
  SymmetricTensorLanes limit(const PointGroup& group, SymmetricTensorLanes trial,
                             const VelocityGradient&, double, const ElasticProperties& properties,
                             const Elastodamage& law) {
    grow_damage(group, trial, properties.moduli(), law);
    const Lanes left = group.load(integrity);
    for (auto& component : trial) component *= left;
    return trial;
  }
  bool failed(int p) const { return integrity[p] == 0; }  ///< the stiffness is zero

  /// Calls f(Field) for each field that a step changes.
  template <class F>
  void for_each_field(F f) {
    for (auto& component : effective_stress) f(component);
    f(strain);
    f(integrity);
  }

 private:
  void grow_damage(const PointGroup& group, const SymmetricTensorLanes& effective,
                   const ElasticModuli& moduli, const Elastodamage& law);
  void damage_point(int p, double largest_strain, const Elastodamage& law);
};

/// Largest principal strain [-] of one of eight points under an elastic stress [Pa].
double largest_principal_strain(const SymmetricTensorLanes& stress, int lane,
                                const ElasticModuli& moduli);

inline void SolidState<Elastodamage>::grow_damage(const PointGroup& group,
                                                  const SymmetricTensorLanes& effective,
                                                  const ElasticModuli& moduli,
                                                  const Elastodamage& law) {
  const Lanes mean = trace(effective) * (1.0 / 3);
  SymmetricTensorLanes deviator = effective;
  for (int c = 0; c < 3; ++c) deviator[c] -= mean;
  // A principal value exceeds the mean by at most sqrt(2/3) times the norm of the deviator.
  const Lanes bound =
      mean * (1 / (3 * moduli.bulk())) +
      square_root(contract(deviator, deviator) * (2.0 / 3)) * (1 / (2 * moduli.shear()));
  const Lanes limit = larger(group.load(strain), broadcast(law.elastic_limit));
  const LaneMask suspect = bound > limit;
  if (!any(suspect, group.count())) return;
  for (int l = 0; l < group.count(); ++l) {
    if (suspect[l]) damage_point(group[l], largest_principal_strain(effective, l, moduli), law);
  }
}

}  // namespace zona::mpm
