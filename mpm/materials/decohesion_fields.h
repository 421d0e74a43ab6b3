#pragma once

#include "mpm/materials/decohesion.h"
#include "mpm/points/material_points.h"

namespace zona::mpm {

/// The surface of decohesion of every point of a body, its normal in `Dimensions` components.
/// Empty where the material knows none.
template <int Dimensions>
struct DecohesionFields {
  /// No surface yet, at any of the points.
  explicit DecohesionFields(int points = 0) {
    for_each([&](Field& field) { field.assign(points, 0.0); });
  }

  std::array<Field, Dimensions> normal;  ///< unit vector; zero where there is no surface
  Field opened;                          ///< lambda^d of (5.36); 1 = failed
  Field tensile_strength;                ///< tau_nf [Pa]; 0 where there is no surface
  Field reference_traction;              ///< tau_0 [Pa]
  Field dissipated;                      ///< by opening [J/m^2]

  bool empty() const { return opened.empty(); }  ///< the material knows no decohesion
  bool failed(int p) const { return !empty() && opened[p] >= 1; }  ///< lambda^d has reached 1
  /// The surface at point p, if it has one.
  DecohesionSurface surface(int p) const { return {tensile_strength[p], reference_traction[p]}; }
  /// Point p gets its surface; the normal is the caller's.
  void start(int p, const DecohesionSurface& surface) {
    tensile_strength[p] = surface.tensile_strength;
    reference_traction[p] = surface.reference_traction;
  }
  /// Calls f(Field) for what steps change.
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
