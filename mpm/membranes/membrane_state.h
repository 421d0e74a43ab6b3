#pragma once

#include <vector>

#include "mpm/materials/elastodamage.h"
#include "mpm/materials/solid.h"
#include "mpm/membranes/membrane_kinematics.h"
#include "mpm/points/material_points.h"

namespace zona::mpm {

/// Elastic for ever, the stress updated by increments of the local strain (5.42) instead of its
/// total. One and the same curve, as Figure 5.9 shows: this law is there to show it.
struct IncrementalElastic {};

/// Stress [Pa] and elastic strain of eight membrane points in their local frames.
struct MembraneResponse {
  InPlane stress;          ///< Cauchy, local xx yy xy [Pa]
  InPlane elastic_strain;  ///< local xx yy xy [-]
};

/// What became of the points of a membrane; a state enters the failures of a step, from any thread.
struct MembraneIntegrity {
  /// All points intact.
  explicit MembraneIntegrity(int points);

  Field left;                     ///< 1 - damage, or 1 - lambda^d; 0 = failed [-]
  Field failure_time;             ///< [s]; infinite while intact
  double time = 0;                ///< of the running step [s]
  std::vector<int> newly_failed;  ///< in this step, in any order

  bool failed(int p) const { return left[p] == 0; }  ///< nothing is left of point p
  void fail(int p);                                  ///< from any thread
};

/// What a law keeps of each point of a membrane. A state has
///     MembraneState(const Law&, int points);          throws ModelError
///     MembraneResponse respond(group, local strain, its principal values, properties, integrity);
///     for_each_field(f);
template <class Law>
struct MembraneState;

/// Nothing to keep: the stress follows from the strain.
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

/// The strain of the last step and the stress that all increments add up to.
template <>
struct MembraneState<IncrementalElastic> {
  /// No strain, no stress.
  MembraneState(const IncrementalElastic&, int points);

  std::array<Field, 3> previous_strain;  ///< local, xx yy xy [-]
  std::array<Field, 3> two_way_stress;   ///< sum of all increments, compression included [Pa]

  /// The summed stress with the one-way law (5.42).
  MembraneResponse respond(const PointGroup& group, const LocalStrain& local, const Principal&,
                           const MembraneProperties& p, MembraneIntegrity&);
  /// Calls f(Field) for what steps change.
  template <class F>
  void for_each_field(F f) {
    for (auto& component : previous_strain) f(component);
    for (auto& component : two_way_stress) f(component);
  }
};

/// The damage of each point, which only grows.
template <>
struct MembraneState<Elastodamage> {
  /// No damage. Throws ModelError.
  MembraneState(const Elastodamage& law, int points);

  Elastodamage law;  ///< its constants
  Field damage;      ///< omega of (5.11) [-]

  /// Lets the damage grow (5.11); the elastic stress times what is left (5.9)-(5.10).
  MembraneResponse respond(const PointGroup& group, const LocalStrain& local, const Principal& e,
                           const MembraneProperties& p, MembraneIntegrity& integrity);
  /// Calls f(Field) for what steps change.
  template <class F>
  void for_each_field(F f) {
    f(damage);
  }

 private:
  void grow_damage(const PointGroup& group, const Lanes& strain, MembraneIntegrity& integrity);
};

}  // namespace zona::mpm
