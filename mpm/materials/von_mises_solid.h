#pragma once

#include "mpm/materials/decohesion_fields.h"
#include "mpm/materials/solid.h"
#include "mpm/materials/von_mises.h"

namespace zona::mpm {

/// State of the points of a von Mises solid: radial return, and decohesion once the flow localises.
/// Only points beyond their strength are processed one by one.
///
/// The return has the direction of the trial stress. If a step leaves the hardening branch and the
/// softening would lose ellipticity, the flow stops at the peak, and the rest of the step's strain
/// opens the surface of decohesion.
template <>
struct SolidState<VonMises> {
  /// Points without plastic strain. Throws ModelError.
  SolidState(const VonMises& law, int points);

  Field internal;                ///< I_s of (5.15) [-]
  Field strength;                ///< limit of the equivalent stress [Pa]
  Field dissipated;              ///< energy dissipated by plastic flow [J/m^3]
  DecohesionFields<3> surfaces;  ///< their normals rotate with the material

  /// The stress itself.
  SymmetricTensorField& elastic_stress(SymmetricTensorField& stress) { return stress; }
  /// The trial stress [Pa], returned to the strength by plastic flow or by opening of the surface.
  SymmetricTensorLanes limit(const PointGroup& group, SymmetricTensorLanes trial,
                             const VelocityGradient& gradient, double dt,
                             const ElasticProperties& properties, const VonMises& law);
  /// True if the surface has opened: the point carries neither tension nor compression.
  bool failed(int p) const { return surfaces.failed(p); }

  /// Calls f(Field) for each field that a step changes.
  template <class F>
  void for_each_field(F f) {
    f(internal);
    f(strength);
    f(dissipated);
    surfaces.for_each_field(f);
  }

 private:
  using Stress = Eigen::Matrix3d;
  void correct(const PointGroup& group, const LaneMask& beyond, SymmetricTensorLanes& stress,
               const VelocityGradient& gradient, double dt, const ElasticModuli& moduli,
               const VonMises& law);
  void flow(int p, Stress& stress, const ElasticModuli& moduli, const VonMises& law);
  bool localise(int p, const Stress& on_surface, const ElasticModuli& moduli, const VonMises& law);
  void open(int p, Stress& stress, const ElasticModuli& moduli, const Decohesion& law);
  /// One update (5.41). Returns true if another may be needed.
  bool open_once(int p, Stress& stress, const Eigen::Vector3d& normal, double length,
                 const ElasticModuli& moduli, const Decohesion& law);
  void turn_normal(int p, const Eigen::Matrix3d& turn);
};

inline SymmetricTensorLanes SolidState<VonMises>::limit(const PointGroup& group,
                                                        SymmetricTensorLanes trial,
                                                        const VelocityGradient& gradient, double dt,
                                                        const ElasticProperties& properties,
                                                        const VonMises& law) {
  const Lanes mean = trace(trial) * (1.0 / 3);
  SymmetricTensorLanes deviator = trial;
  for (int c = 0; c < 3; ++c) deviator[c] -= mean;
  const Lanes allowed = group.load(strength);
  LaneMask beyond = 1.5 * contract(deviator, deviator) > allowed * allowed;
  if (!surfaces.empty()) beyond |= group.load(surfaces.tensile_strength) > 0.0;
  if (any(beyond, group.count())) {
    correct(group, beyond, trial, gradient, dt, properties.moduli(), law);
  }
  return trial;
}

}  // namespace zona::mpm
