#pragma once

#include "mpm/materials/rigid_motion.h"
#include "mpm/points/material_points.h"

namespace zona::mpm {

/// Coupling of a body with prescribed motion to its surroundings.
enum class Drive {
  points,  ///< through its points: the grid averages the motion by mass, without slip
  nodes    ///< also overrides every node that its points touch; a much stiffer coupling
};

/// A rigid body with a prescribed translation, or a fixed body. It carries no stress.
struct Prescribed {
  /// Its points contribute no internal forces.
  static constexpr bool has_stress = false;

  /// `motion` is empty for a fixed body. The points start at their current positions.
  Prescribed(const MaterialPoints& points, double density, RigidMotion motion = {},
             Drive drive = Drive::points);

  double density;                                      ///< [kg/m^3]
  RigidMotion motion;                                  ///< empty for a fixed body
  Drive drive;                                         ///< coupling to the surroundings
  std::array<Field, 3> initial_position;               ///< [m]
  RigidState next;                                     ///< at the end of the current step
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();  ///< force on the surroundings [N], last step
  std::vector<Eigen::Vector3d> brick_impulse;  ///< each brick's share in the current step [N s]

  /// State at `time` [s]; at rest for a fixed body.
  RigidState state(double time) const { return motion ? motion(time) : RigidState{}; }
  double wave_speed() const { return 0; }        ///< none, so the body does not limit the step
  double shear_wave_speed() const { return 0; }  ///< none

  /// Calls f(Field) for each field that follows the order of storage.
  template <class F>
  void for_each_field(F f) {
    for (auto& component : initial_position) f(component);
  }
};

}  // namespace zona::mpm
