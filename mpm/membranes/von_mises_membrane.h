#pragma once

#include "mpm/materials/decohesion_fields.h"
#include "mpm/materials/von_mises.h"
#include "mpm/membranes/membrane_state.h"

namespace zona::mpm {

/// Points of a von Mises membrane: plane stress return, and where the flow localises, decohesion.
/// Only points beyond their strength leave the eight lanes.
///
/// The one-way law acts on the elastic strain, the local strain less what has flowed and opened, so
/// that wrinkles stay free of stress. Where the membrane is wrinkled its stress has one axis, and
/// so has the return: the stress falls along that axis alone, while the flow has all its
/// components.
template <>
struct MembraneState<VonMises> {
  /// Throws ModelError.
  MembraneState(const VonMises& law, int points);

  VonMises law;                           ///< its constants
  std::array<Field, 3> inelastic_strain;  ///< plastic and by decohesion, local xx yy xy [-]
  Field internal;                         ///< I_s of (5.15) [-]
  Field strength;                         ///< what the equivalent stress may be [Pa]
  Field dissipated;                       ///< by plastic flow [J/m^3]
  DecohesionFields<2> surfaces;           ///< normals in the local frame

  /// Stress after plastic flow, or after opening of the surface.
  MembraneResponse respond(const PointGroup& group, const LocalStrain& local, const Principal&,
                           const MembraneProperties& p, MembraneIntegrity& integrity);
  /// Calls f(Field) for what steps change.
  template <class F>
  void for_each_field(F f) {
    for (auto& component : inelastic_strain) f(component);
    f(internal);
    f(strength);
    f(dissipated);
    surfaces.for_each_field(f);
  }

 private:
  bool has_surface(int p) const { return !surfaces.empty() && surfaces.surface(p).present(); }
  void flow(int p, PlaneTensor& elastic, const MembraneProperties& properties);
  bool localise(int p, const PrincipalValues<double>& on_surface,
                const MembraneProperties& properties);
  /// Opens the surface; `frame` are the local axes in space.
  void open(int p, PlaneTensor& elastic, const Eigen::Matrix<double, 3, 2>& frame,
            const MembraneProperties& properties);
  /// One step (5.41). Whether another may be needed.
  bool open_once(int p, PlaneTensor& elastic, const Eigen::Vector2d& normal, double length,
                 const MembraneProperties& properties);
  void make_inelastic(int p, const PlaneTensor& strain, PlaneTensor& elastic);
};

}  // namespace zona::mpm
