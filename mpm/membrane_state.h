#pragma once

#include <vector>

#include "mpm/elastodamage.h"
#include "mpm/material_points.h"
#include "mpm/membrane_kinematics.h"
#include "mpm/solid.h"

namespace zona::mpm {

/// Elastic for ever, the stress updated by increments of the local strain (5.42) instead of its
/// total. One and the same curve, as Figure 5.9 shows: this law is there to show it.
struct IncrementalElastic {};

/// Stress [Pa] and elastic strain of eight membrane points in their local frames.
struct MembraneResponse {
  InPlane stress;
  InPlane elastic_strain;
};

/// What became of the points of a membrane; a state enters the failures of a step, from any thread.
struct MembraneIntegrity {
  explicit MembraneIntegrity(int points);

  Field left;          ///< 1 - damage, or 1 - lambda^d; 0 = failed [-]
  Field failure_time;  ///< [s]; infinite while intact
  double time = 0;     ///< of the running step [s]
  std::vector<int> newly_failed;

  bool failed(int p) const { return left[p] == 0; }
  void fail(int p);
};

/// What a law keeps of each point of a membrane. A state has
///     MembraneState(const Law&, int points);          throws ModelError
///     MembraneResponse respond(group, local strain, its principal values, properties, integrity);
///     for_each_field(f);
template <class Law>
struct MembraneState;

template <>
struct MembraneState<Elastic> {
  MembraneState(const Elastic&, int) {}
  MembraneResponse respond(const PointGroup&, const LocalStrain& local, const Principal& e,
                           const MembraneProperties& p, MembraneIntegrity&) const {
    return {membrane_stress(e, p), local.strain};
  }
  template <class F>
  void for_each_field(F) {}
};

template <>
struct MembraneState<IncrementalElastic> {
  MembraneState(const IncrementalElastic&, int points);

  std::array<Field, 3> previous_strain;  ///< local, xx yy xy [-]
  std::array<Field, 3> two_way_stress;   ///< sum of all increments, compression included [Pa]

  MembraneResponse respond(const PointGroup& group, const LocalStrain& local, const Principal&,
                           const MembraneProperties& p, MembraneIntegrity&);
  template <class F>
  void for_each_field(F f) {
    for (auto& component : previous_strain) f(component);
    for (auto& component : two_way_stress) f(component);
  }
};

template <>
struct MembraneState<Elastodamage> {
  MembraneState(const Elastodamage& law, int points);

  Elastodamage law;
  Field damage;  ///< omega of (5.11) [-]

  MembraneResponse respond(const PointGroup& group, const LocalStrain& local, const Principal& e,
                           const MembraneProperties& p, MembraneIntegrity& integrity);
  template <class F>
  void for_each_field(F f) {
    f(damage);
  }

 private:
  void grow_damage(const PointGroup& group, const Lanes& strain, MembraneIntegrity& integrity);
};

}  // namespace zona::mpm
