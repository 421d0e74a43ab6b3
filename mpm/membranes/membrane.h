#pragma once

#include "mpm/membranes/von_mises_membrane.h"

namespace zona::mpm {

/// Material laws of a membrane; VonMises contains its decohesion.
using MembraneLaw = std::variant<Elastic, IncrementalElastic, Elastodamage, VonMises>;

/// A membrane without bending stiffness (4.1): triangulated points in plane stress, with the
/// one-way law and a law of failure (5.3). Failed points keep their mass and lose their stress;
/// their triangles no longer contribute to normals. The points are never reordered, because
/// triangles refer to them by storage index.
struct Membrane {
  /// Its points contribute internal forces.
  static constexpr bool has_stress = true;

  /// `objective` selects DeformationGradientKinematics instead of SummedStrainKinematics. Throws
  /// ModelError.
  Membrane(const MembraneProperties& properties, const MembraneLaw& law, bool objective,
           const MaterialPoints& points, std::vector<Triangle> triangles);

  /// State of the law, per point.
  using State = std::variant<MembraneState<Elastic>, MembraneState<IncrementalElastic>,
                             MembraneState<Elastodamage>, MembraneState<VonMises>>;

  MembraneProperties properties;  ///< constants of all points
  Surface surface;                ///< its triangles
  MembraneKinematics kinematics;  ///< strains and local frames of the points
  State state;                    ///< of the law
  MembraneIntegrity integrity;    ///< damage and failures of the points
  SymmetricTensorField stress;    ///< Cauchy, fixed axes [Pa]
  Field strain;                   ///< largest principal in-plane strain [-]
  Field energy_density;           ///< sigma : elastic strain / 2 [J/m^3]
  Field reference_area;           ///< of the intact, undeformed membrane [m^2]
  int failed_points = 0;          ///< number of failed points

  bool failed(int p) const { return integrity.failed(p); }  ///< true if point p has failed
  /// In-plane wave speed sqrt(E / (1 - nu^2) / density) [m/s].
  double wave_speed() const;
  double shear_wave_speed() const { return 0; }  ///< ignored by absorbing faces [m/s]
  /// Constant volume [m^3] of a group of this mass [kg].
  Lanes volume(const PointGroup&, const Lanes& mass) const {
    return mass * (1 / properties.density);
  }
  /// Adds the strain increments from the grid; `update_stress` computes the stress.
  LaneMask update(const PointGroup& group, const VelocityGradient& gradient, double dt, double) {
    std::visit([&](auto& k) { k.accumulate(group, gradient, dt); }, kinematics);
    return LaneMask{};
  }
  /// Computes stress, damage and failure at the positions [m] and the time [s] of the end of a
  /// step.
  void update_stress(const std::array<Field, 3>& position, double time, int threads);
  /// Drops the triangles of all failed points, after the fields were restored.
  void drop_all_failed();
  /// Calls f(Field) for each field that a step changes; the intact triangles follow from them.
  template <class F>
  void for_each_field(F f) {
    std::visit([&](auto& k) { k.for_each_field(f); }, kinematics);
    std::visit([&](auto& s) { s.for_each_field(f); }, state);
    f(integrity.left);
    f(integrity.failure_time);
    for (auto& component : stress) f(component);
    f(strain);
    f(energy_density);
  }

 private:
  template <class Kinematics, class LawState>
  void update_group(const Kinematics& kinematics, LawState& law_state, const PointGroup& group);
  void drop_failed();
  void drop(int p);
};

}  // namespace zona::mpm
