#pragma once

#include <optional>

#include "mpm/membrane_kinematics.h"

namespace zona::mpm {

/// A membrane without bending stiffness (4.1): triangulated points in plane stress, with the
/// one-way law and, optionally, elastodamage (5.3). Failed points keep their mass, lose their
/// stress, and their triangles leave the normals. Its points are never re-ordered: triangles name
/// them.
struct Membrane {
  static constexpr bool has_stress = true;

  /// `objective` chooses DeformationGradientKinematics, else SummedStrainKinematics. Throws
  /// ModelError.
  Membrane(const MembraneProperties& properties, std::optional<Elastodamage> damage_law,
           bool objective, const MaterialPoints& points, std::vector<Triangle> triangles);

  MembraneProperties properties;
  std::optional<Elastodamage> damage_law;
  Surface surface;
  MembraneKinematics kinematics;
  SymmetricTensorField stress;  ///< Cauchy, fixed axes [Pa]
  Field strain;                 ///< largest principal in-plane strain [-]
  Field damage;                 ///< omega of (5.11) [-]
  Field integrity;              ///< secant over elastic stiffness; 0 = failed [-]
  Field failure_time;           ///< [s]; infinite while intact
  Field energy_density;         ///< sigma : epsilon / 2 [J/m^3]
  Field reference_area;         ///< of the intact, undeformed membrane [m^2]
  int failed_points = 0;

  bool failed(int p) const { return integrity[p] == 0; }
  double wave_speed() const;
  double shear_wave_speed() const { return 0; }
  Lanes volume(const PointGroup&, const Lanes& mass) const {
    return mass * (1 / properties.density);
  }
  /// The strain increments from the grid; the stress follows in `update_stress`.
  LaneMask update(const PointGroup& group, const VelocityGradient& gradient, double dt, double) {
    std::visit([&](auto& k) { k.accumulate(group, gradient, dt); }, kinematics);
    return LaneMask{};
  }
  /// Stress, damage and failure at the positions [m] of the end of the step, at `time` [s].
  void update_stress(const std::array<Field, 3>& position, double time, int threads);

 private:
  template <class K>
  void update_group(const K& kinematics, const PointGroup& group, double time,
                    std::vector<int>& newly_failed);
  void grow_damage(const PointGroup& group, const Lanes& largest_strain, double time,
                   std::vector<int>& newly_failed);
  void drop_failed(std::vector<int>& newly_failed);
};

}  // namespace zona::mpm
