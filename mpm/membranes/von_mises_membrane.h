#pragma once

#include "mpm/materials/decohesion_fields.h"
#include "mpm/materials/von_mises.h"
#include "mpm/membranes/membrane_state.h"

namespace zona::mpm {

/// State of the points of a von Mises membrane: plane stress return, and decohesion once the flow
/// localises. Only points beyond their strength are processed one by one.
///
/// The one-way law acts on the elastic strain, i.e. the local strain minus the plastic strain and
/// the opening, so wrinkles stay free of stress. A wrinkled membrane has uniaxial stress: the
/// return lowers the stress along that axis only, while the plastic flow has all its components.
template <>
struct MembraneState<VonMises> {
  /// Points without plastic strain. Throws ModelError.
  MembraneState(const VonMises& law, int points);

  VonMises law;                           ///< its constants
  std::array<Field, 3> inelastic_strain;  ///< plastic and by decohesion, local xx yy xy [-]
  Field internal;                         ///< I_s of (5.15) [-]
  Field strength;                         ///< limit of the equivalent stress [Pa]
  Field dissipated;                       ///< energy dissipated by plastic flow [J/m^3]
  DecohesionFields<2> surfaces;           ///< normals in the local frame

  /// Stress after plastic flow or after opening of the surface.
  MembraneResponse respond(const PointGroup& group, const LocalStrain& local, const Principal&,
                           const MembraneProperties& p, MembraneIntegrity& integrity);
  /// Calls f(Field) for each field that a step changes.
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
  /// Opens the surface; `frame` holds the local axes in space.
  void open(int p, PlaneTensor& elastic, const Eigen::Matrix<double, 3, 2>& frame,
            const MembraneProperties& properties);
  /// One update (5.41). Returns true if another may be needed.
  bool open_once(int p, PlaneTensor& elastic, const Eigen::Vector2d& normal, double length,
                 const MembraneProperties& properties);
  void make_inelastic(int p, const PlaneTensor& strain, PlaneTensor& elastic);
};

}  // namespace zona::mpm
