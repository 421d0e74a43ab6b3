#pragma once

#include <functional>

#include "mpm/bodies/body.h"
#include "mpm/grid/background_grid.h"
#include "mpm/grid/region.h"

namespace zona::mpm {

/// Which velocity components a face holds at zero: none for free and absorbing faces, the normal
/// one for rollers, all for fixed faces.
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

/// Velocity and acceleration of the grid at the faces, after the momentum is advanced.
void hold_faces(BackgroundGrid& grid, const FaceConditions& faces);
/// The same for the velocities mapped back from the points.
void hold_updated_faces(BackgroundGrid& grid, const FaceConditions& faces);

/// Nodes that move as prescribed, in the components of `axes`.
///
/// A held component has the velocity V at the end of the step and the acceleration that V has, not
/// the one that would undo what the points brought to the node: as at the faces, and with the same
/// order of accuracy. Only the first step jumps to a V that does not start from rest. Later holds
/// win where regions overlap, and over the faces.
struct HeldNodes {
  Box region;                                  ///< of the nodes' places
  std::array<bool, 3> axes{true, true, true};  ///< components that are held
  /// [m/s], of time [s] and the node's place [m]; empty: zero
  std::function<Eigen::Vector3d(double, const Eigen::Vector3d&)> velocity{};
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();  ///< force on the points [N], last step
  double power = 0;                                    ///< of that force [W]
};

/// Nodes whose places lie in the box, in ascending order. Throws ModelError if there are none.
std::vector<int> nodes_in(const BackgroundGrid& grid, const Box& region);
/// Velocity and acceleration of held nodes in the step from `time` to `time` + dt [s], after the
/// momentum is advanced; sets the reaction. `pic` is the fraction of the nodes' velocity, not their
/// acceleration, that reaches the points.
void hold_nodes(BackgroundGrid& grid, const std::vector<int>& nodes, HeldNodes& held, double time,
                double dt, double pic);
/// The same for the velocities mapped back from the points; `time` [s] is the end of the step.
void hold_updated_nodes(BackgroundGrid& grid, const std::vector<int>& nodes, const HeldNodes& held,
                        double time);

/// Viscous tractions -rho c v (5.43)-(5.50) on the nodes of absorbing faces, normal to the face
/// with the primary and along it with the secondary wave speed of what touches the node.
///
/// The source lets the points of the outermost layer act, (5.52)-(5.55), which puts half of the
/// traction one cell inside and takes the velocity half a cell away: it sends back a fraction of
/// order k h. On the face itself, where rho dS is 2 m_i / h for the lumped mass m_i (3 m_i / h for
/// quadratic functions, as the outermost one holds a third of its cell), it is of order (k h)^2.
void absorb_at_faces(BackgroundGrid& grid, const FaceConditions& faces);

/// Nodes that the points of a body touch, each once, in ascending order.
std::vector<int> touched_nodes(const BackgroundGrid& grid, const CellIndex& cells);

/// Gives nodes a velocity [m/s] after the momentum is advanced by dt [s]; returns the momentum that
/// it takes [N s].
Eigen::Vector3d override_velocity(BackgroundGrid& grid, const std::vector<int>& nodes,
                                  const Eigen::Vector3d& velocity, double dt);
/// The same for the velocities mapped back from the points.
void override_updated_velocity(BackgroundGrid& grid, const std::vector<int>& nodes,
                               const Eigen::Vector3d& velocity);

}  // namespace zona::mpm
