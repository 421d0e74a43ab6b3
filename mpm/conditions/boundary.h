#pragma once

#include <functional>

#include "mpm/bodies/body.h"
#include "mpm/grid/background_grid.h"
#include "mpm/grid/region.h"

namespace zona::mpm {

/// True if a face holds the velocity component `axis` at zero: none for free and absorbing faces,
/// the normal one for rollers, all for fixed faces.
bool holds(FaceCondition condition, int normal_axis, int axis);

/// Calls f(node) for the nodes of a face.
template <class F>
void for_each_node(const BackgroundGrid& grid, int face, F f) {
  const auto& n = grid.nodes_along();
  const int normal = face / 2;
  const int u = (normal + 1) % 3;
  const int w = (normal + 2) % 3;
  std::array<int, 3> at{};
  at[normal] = face % 2 == 0 ? 0 : n[normal] - 1;
  for (at[u] = 0; at[u] < n[u]; ++at[u]) {
    for (at[w] = 0; at[w] < n[w]; ++at[w]) f(grid.node_index(at[0], at[1], at[2]));
  }
}

/// Calls f(node, axis) for every velocity component that the faces hold.
template <class F>
void for_each_held(const BackgroundGrid& grid, const FaceConditions& faces, F f) {
  for (int face = 0; face < 6; ++face) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!holds(faces[face], face / 2, axis)) continue;
      for_each_node(grid, face, [&](int node) { f(node, axis); });
    }
  }
}

/// Sets held velocities and accelerations at the faces to zero, after the momentum is advanced.
void hold_faces(BackgroundGrid& grid, const FaceConditions& faces);
/// Does the same for the velocities mapped back from the points.
void hold_updated_faces(BackgroundGrid& grid, const FaceConditions& faces);

/// Nodes whose motion is prescribed in the components `axes`.
///
/// A held component gets the prescribed velocity V at the end of the step and the acceleration of
/// V, not the acceleration that would cancel the momentum from the points. Faces are treated alike,
/// with the same order of accuracy. Only the first step jumps to V if V does not start from rest.
/// Where regions overlap, later entries win; all win over the faces.
struct HeldNodes {
  Box region;                                  ///< contains the nodes
  std::array<bool, 3> axes{true, true, true};  ///< components that are held
  /// Velocity [m/s] as a function of time [s] and the node's place [m]; empty for zero.
  std::function<Eigen::Vector3d(double, const Eigen::Vector3d&)> velocity{};
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();  ///< force on the points [N], last step
  double power = 0;                                    ///< of that force [W]
};

/// Velocity of a held node [m/s] at `time` [s].
Eigen::Vector3d velocity_of(const HeldNodes& held, double time, const BackgroundGrid& grid,
                            int node);
/// Nodes in the box, in ascending order. Throws ModelError if there are none.
std::vector<int> nodes_in(const BackgroundGrid& grid, const Box& region);
/// Sets velocity and acceleration of held nodes in the step from `time` to `time` + dt [s], after
/// the momentum is advanced, and computes the reaction. `pic` is the fraction of PIC in the points'
/// velocity.
void hold_nodes(BackgroundGrid& grid, const std::vector<int>& nodes, HeldNodes& held, double time,
                double dt, double pic);
/// Sets the velocities mapped back from the points; `time` [s] is the end of the step.
void hold_updated_nodes(BackgroundGrid& grid, const std::vector<int>& nodes, const HeldNodes& held,
                        double time);

/// Applies viscous tractions -rho c v (5.43)-(5.50) to the nodes of absorbing faces, normal to the
/// face with the primary and along it with the secondary wave speed of the material at the node.
///
/// The source applies them to the outermost layer of points, (5.52)-(5.55). This puts half of the
/// traction one cell inside, takes the velocity half a cell away, and reflects a fraction of order
/// k h. On the face itself rho dS is 2 m_i / h for the lumped mass m_i (3 m_i / h for quadratic
/// functions, whose outermost one has a third of its cell's mass), and the reflection is of order
/// (k h)^2. Where the pressure is implicit the normal tractions are, too: `only_tangential`.
void absorb_at_faces(BackgroundGrid& grid, const FaceConditions& faces,
                     bool only_tangential = false);

/// Nodes of all cells that contain points of a body, in ascending order.
std::vector<int> touched_nodes(const BackgroundGrid& grid, const CellIndex& cells);

/// Sets the velocity of nodes [m/s] after the momentum is advanced by dt [s]. Returns the momentum
/// that this adds [N s].
Eigen::Vector3d override_velocity(BackgroundGrid& grid, const std::vector<int>& nodes,
                                  const Eigen::Vector3d& velocity, double dt);
/// Sets the velocities mapped back from the points.
void override_updated_velocity(BackgroundGrid& grid, const std::vector<int>& nodes,
                               const Eigen::Vector3d& velocity);

}  // namespace zona::mpm
