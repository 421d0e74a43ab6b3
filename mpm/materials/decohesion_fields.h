#pragma once

#include "mpm/materials/decohesion.h"
#include "mpm/points/material_points.h"

namespace zona::mpm {

/// Surfaces of decohesion of all points of a body, their normals in `Dimensions` components. Empty
/// for materials without decohesion.
template <int Dimensions>
struct DecohesionFields {
  /// Points without surfaces.
  explicit DecohesionFields(int points = 0) {
    for_each([&](Field& field) { field.assign(points, 0.0); });
  }

  std::array<Field, Dimensions> normal;  ///< unit vector; zero where there is no surface
  Field opened;                          ///< lambda^d of (5.36); 1 = failed
  Field tensile_strength;                ///< tau_nf [Pa]; 0 where there is no surface
  Field reference_traction;              ///< tau_0 [Pa]
  Field dissipated;                      ///< energy dissipated by opening [J/m^2]

  bool empty() const { return opened.empty(); }  ///< true for materials without decohesion
  bool failed(int p) const { return !empty() && opened[p] >= 1; }  ///< lambda^d has reached 1
  /// The surface at point p, which may be absent.
  DecohesionSurface surface(int p) const { return {tensile_strength[p], reference_traction[p]}; }
  /// Creates the surface at point p; the caller sets its normal.
  void start(int p, const DecohesionSurface& surface) {
    tensile_strength[p] = surface.tensile_strength;
    reference_traction[p] = surface.reference_traction;
  }
  /// Calls f(Field) for each field that a step changes.
  template <class F>
  void for_each_field(F f) {
    if (!empty()) for_each(f);
  }

 private:
  template <class F>
  void for_each(F f) {
    for (auto& component : normal) f(component);
    f(opened);
    f(tensile_strength);
    f(reference_traction);
    f(dissipated);
  }
};

}  // namespace zona::mpm
