#pragma once

#include "mpm/materials/rigid_motion.h"
#include "mpm/points/material_points.h"

namespace zona::mpm {

/// How a body that moves as prescribed drives what surrounds it.
enum class Drive {
  points,  ///< its points carry the motion; the grid mixes it with the rest by mass, no slip
  nodes    ///< every node that its points touch is overridden as well: much harsher
};

/// A rigid body whose translation is prescribed; a fixed body is one that stays. It carries no
/// stress.
struct Prescribed {
  /// Its points bring no internal forces.
  static constexpr bool has_stress = false;

  /// `motion` is empty for a fixed body. The initial positions are those of `points`.
  Prescribed(const MaterialPoints& points, double density, RigidMotion motion = {},
             Drive drive = Drive::points);

  double density;                                      ///< [kg/m^3]
  RigidMotion motion;                                  ///< empty for a fixed body
  Drive drive;                                         ///< how it drives its surroundings
  std::array<Field, 3> initial_position;               ///< [m]
  RigidState next;                                     ///< at the end of the running step
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();  ///< force on the surroundings [N], last step
  std::vector<Eigen::Vector3d> brick_impulse;  ///< [N s], each brick's share of the running step

  /// At `time` [s]; that of a fixed body is rest.
  RigidState state(double time) const { return motion ? motion(time) : RigidState{}; }
  double wave_speed() const { return 0; }        ///< none: it does not limit the step
  double shear_wave_speed() const { return 0; }  ///< none

  /// Calls f(Field) for what storage re-orders.
  template <class F>
  void for_each_field(F f) {
    for (auto& component : initial_position) f(component);
  }
};

}  // namespace zona::mpm
