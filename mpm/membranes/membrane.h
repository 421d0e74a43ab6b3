#pragma once

#include "mpm/membranes/von_mises_membrane.h"

namespace zona::mpm {

/// How the points of a membrane carry stress and fail; von Mises brings its decohesion along.
using MembraneLaw = std::variant<Elastic, IncrementalElastic, Elastodamage, VonMises>;

/// A membrane without bending stiffness (4.1): triangulated points in plane stress, with the
/// one-way law and a law of failure (5.3). Failed points keep their mass, lose their stress, and
/// their triangles leave the normals. Its points are never re-ordered: triangles name them.
struct Membrane {
  /// Its points bring internal forces.
  static constexpr bool has_stress = true;

  /// `objective` chooses DeformationGradientKinematics, else SummedStrainKinematics. Throws
  /// ModelError.
  Membrane(const MembraneProperties& properties, const MembraneLaw& law, bool objective,
           const MaterialPoints& points, std::vector<Triangle> triangles);

  /// What the law keeps of each point.
  using State = std::variant<MembraneState<Elastic>, MembraneState<IncrementalElastic>,
                             MembraneState<Elastodamage>, MembraneState<VonMises>>;

  MembraneProperties properties;  ///< constants of all points
  Surface surface;                ///< its triangles
  MembraneKinematics kinematics;  ///< strains and local frames of the points
  State state;                    ///< of the law
  MembraneIntegrity integrity;    ///< what is left of each point
  SymmetricTensorField stress;    ///< Cauchy, fixed axes [Pa]
  Field strain;                   ///< largest principal in-plane strain [-]
  Field energy_density;           ///< sigma : elastic strain / 2 [J/m^3]
  Field reference_area;           ///< of the intact, undeformed membrane [m^2]
  int failed_points = 0;          ///< so far

  bool failed(int p) const { return integrity.failed(p); }  ///< nothing is left of point p
  /// In its plane, sqrt(E / (1 - nu^2) / density) [m/s].
  double wave_speed() const;
  double shear_wave_speed() const { return 0; }  ///< absorbing faces see none [m/s]
  /// Volume [m^3] of a group of this mass [kg]; it does not change.
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
  /// What of the failed points does not follow from the fields; after these were restored.
  void drop_all_failed();
  /// What steps change, in the order of the points; which triangles are intact follows.
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
