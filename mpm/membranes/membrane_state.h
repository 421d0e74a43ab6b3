#pragma once

#include <vector>

#include "mpm/materials/elastodamage.h"
#include "mpm/materials/solid.h"
#include "mpm/membranes/membrane_kinematics.h"
#include "mpm/points/material_points.h"

namespace zona::mpm {

/// Linear elasticity whose stress is updated by increments of the local strain (5.42) instead of
/// the total strain. Both give the same curve; this law exists to show it (Figure 5.9).
struct IncrementalElastic {};

/// Stress [Pa] and elastic strain of eight membrane points in their local frames.
struct MembraneResponse {
  InPlane stress;          ///< Cauchy, local xx yy xy [Pa]
  InPlane elastic_strain;  ///< local xx yy xy [-]
};

/// Damage and failures of the points of a membrane. The state of a law records the failures of a
/// step, from any thread.
struct MembraneIntegrity {
  /// Intact points.
  explicit MembraneIntegrity(int points);

  Field left;                     ///< 1 - damage, or 1 - lambda^d; 0 = failed [-]
  Field failure_time;             ///< [s]; infinite while intact
  double time = 0;                ///< of the current step [s]
  std::vector<int> newly_failed;  ///< in this step, in any order

  bool failed(int p) const { return left[p] == 0; }  ///< true if point p has failed
  void fail(int p);  ///< records the failure of point p; may be called from any thread
};

/// State of a membrane's points under a law. A state has
///     MembraneState(const Law&, int points);          throws ModelError
///     MembraneResponse respond(group, local strain, its principal values, properties, integrity);
///     for_each_field(f);
template <class Law>
struct MembraneState;

/// Linear elasticity: no state, the stress follows from the strain.
template <>
struct MembraneState<Elastic> {
  /// See MembraneState.
  MembraneState(const Elastic&, int) {}
  /// Plane stress (4.7)-(4.8) with the one-way law.
  MembraneResponse respond(const PointGroup&, const LocalStrain& local, const Principal& e,
                           const MembraneProperties& p, MembraneIntegrity&) const {
    return {membrane_stress(e, p), local.strain};
  }
  /// No fields.
  template <class F>
  void for_each_field(F) {}
};

/// Strain of the previous step and the sum of all stress increments.
template <>
struct MembraneState<IncrementalElastic> {
  /// Zero strain and stress.
  MembraneState(const IncrementalElastic&, int points);

  std::array<Field, 3> previous_strain;  ///< local, xx yy xy [-]
  std::array<Field, 3> two_way_stress;   ///< sum of all increments, compression included [Pa]

  /// The summed stress with the one-way law (5.42).
  MembraneResponse respond(const PointGroup& group, const LocalStrain& local, const Principal&,
                           const MembraneProperties& p, MembraneIntegrity&);
  /// Calls f(Field) for each field that a step changes.
  template <class F>
  void for_each_field(F f) {
    for (auto& component : previous_strain) f(component);
    for (auto& component : two_way_stress) f(component);
  }
};

/// Damage of each point; it never decreases.
template <>
struct MembraneState<Elastodamage> {
  /// Undamaged points. Throws ModelError.
  MembraneState(const Elastodamage& law, int points);

  Elastodamage law;  ///< its constants
  Field damage;      ///< omega of (5.11) [-]

  /// Updates the damage (5.11) and returns the elastic stress times the integrity (5.9)-(5.10).
  MembraneResponse respond(const PointGroup& group, const LocalStrain& local, const Principal& e,
                           const MembraneProperties& p, MembraneIntegrity& integrity);
  /// Calls f(Field) for each field that a step changes.
  template <class F>
  void for_each_field(F f) {
    f(damage);
  }

 private:
  void grow_damage(const PointGroup& group, const Lanes& strain, MembraneIntegrity& integrity);
};

}  // namespace zona::mpm
