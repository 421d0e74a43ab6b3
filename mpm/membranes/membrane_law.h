#pragma once

#include "mpm/materials/elastic_moduli.h"
#include "mpm/points/plane_tensor.h"

namespace zona::mpm {

/// Behaviour of a membrane under compression.
enum class OneWay {
  stress,  ///< taut, wrinkled (uniaxial stress) or slack, according to the principal stresses
  strain,  ///< as in 4.1: sets negative principal strains to zero before the plane-stress law
  off      ///< carries compression
};

/// Constants of a membrane.
struct MembraneProperties {
  double density;                   ///< [kg/m^3]
  double thickness;                 ///< [m]
  double youngs_modulus;            ///< E [Pa]
  double poisson_ratio;             ///< nu [-]
  OneWay one_way = OneWay::stress;  ///< behaviour under compression

  /// The elastic moduli.
  ElasticModuli moduli() const { return {youngs_modulus, poisson_ratio}; }
};

/// Elastic plane stress [Pa] (4.7)-(4.8) with the one-way law: its principal values for the
/// principal elastic strains `e`, with the same axes.
template <class T>
inline PrincipalValues<T> one_way_stress(const PrincipalValues<T>& e, const MembraneProperties& p) {
  const double plane_stress = p.moduli().plane_stress();
  const T zero{};
  T e1 = e.first;
  T e2 = e.second;
  if (p.one_way == OneWay::strain) {
    e1 = larger(e1, zero);
    e2 = larger(e2, zero);
  }
  T s1 = plane_stress * (e1 + p.poisson_ratio * e2);
  T s2 = plane_stress * (e2 + p.poisson_ratio * e1);
  if (p.one_way == OneWay::stress) {
    const auto wrinkled = s2 < 0.0;
    s1 = select(wrinkled, larger(p.youngs_modulus * e1, zero), s1);
    s2 = select(wrinkled, zero, s2);
  }
  return {s1, s2, e.cos2, e.sin2};
}

/// The same stress, as components in the local frame.
inline InPlane membrane_stress(const Principal& e, const MembraneProperties& p) {
  return in_axes(one_way_stress(e, p));
}

}  // namespace zona::mpm
