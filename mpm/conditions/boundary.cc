#include "mpm/conditions/boundary.h"

#include <fmt/format.h>

#include <algorithm>

#include "mpm/grid/cell.h"
#include "mpm/points/errors.h"

namespace zona::mpm {

Eigen::Vector3d velocity_of(const HeldNodes& held, double time, const BackgroundGrid& grid,
                            int node) {
  if (!held.velocity) return Eigen::Vector3d::Zero();
  return held.velocity(time, grid.node_position(node));
}

bool holds(FaceCondition condition, int normal_axis, int axis) {
  return condition == FaceCondition::fixed ||
         (condition == FaceCondition::roller && axis == normal_axis);
}

void hold_faces(BackgroundGrid& grid, const FaceConditions& faces) {
  for_each_held(grid, faces, [&](int node, int axis) {
    grid.state[node][1 + axis] = 0;
    grid.state[node][4 + axis] = 0;
  });
}

void hold_updated_faces(BackgroundGrid& grid, const FaceConditions& faces) {
  for_each_held(grid, faces, [&](int node, int axis) { grid.updated[node][axis] = 0; });
}

std::vector<int> nodes_in(const BackgroundGrid& grid, const Box& region) {
  std::vector<int> nodes;
  const auto& along = grid.nodes_along();
  for (int k = 0; k < along[2]; ++k) {
    for (int j = 0; j < along[1]; ++j) {
      for (int i = 0; i < along[0]; ++i) {
        if (region.contains(grid.node_position(i, j, k))) nodes.push_back(grid.node_index(i, j, k));
      }
    }
  }
  if (!nodes.empty()) return nodes;
  const auto& low = region.low;
  const auto& high = region.high;
  throw ModelError(fmt::format(
      "no node of the grid lies in [{}, {}] x [{}, {}] x [{}, {}] m; enlarge the region of held "
      "nodes",
      low.x(), high.x(), low.y(), high.y(), low.z(), high.z()));
}

void hold_nodes(BackgroundGrid& grid, const std::vector<int>& nodes, HeldNodes& held, double time,
                double dt, double pic) {
  const bool jumps = held.velocity && time == 0;
  held.reaction.setZero();
  held.power = 0;
  for (int node : nodes) {
    const Eigen::Vector3d before = velocity_of(held, time, grid, node);
    const Eigen::Vector3d velocity = velocity_of(held, time + dt, grid, node);
    Lanes& state = grid.state[node];
    for (int axis = 0; axis < 3; ++axis) {
      if (!held.axes[axis]) continue;
      const double free = state[4 + axis];
      const double start = jumps ? state[1 + axis] - dt * free : before[axis];
      const double acceleration = (velocity[axis] - start) / dt;
      const double jump = velocity[axis] - state[1 + axis];
      const double force = state[0] * ((1 - pic) * (acceleration - free) + pic * jump / dt);
      held.reaction[axis] += force;
      held.power += force * velocity[axis];
      state[1 + axis] = velocity[axis];
      state[4 + axis] = acceleration;
    }
  }
}

void hold_updated_nodes(BackgroundGrid& grid, const std::vector<int>& nodes, const HeldNodes& held,
                        double time) {
  for (int node : nodes) {
    const Eigen::Vector3d velocity = velocity_of(held, time, grid, node);
    for (int axis = 0; axis < 3; ++axis) {
      if (held.axes[axis]) grid.updated[node][axis] = velocity[axis];
    }
  }
}

void absorb_at_faces(BackgroundGrid& grid, const FaceConditions& faces, bool only_tangential) {
  for (int face = 0; face < 6; ++face) {
    if (faces[face] != FaceCondition::absorbing) continue;
    const int normal = face / 2;
    const double share = grid.interpolation() == Interpolation::quadratic ? 3 : 2;
    const double per_length = share / grid.cell_size()[normal];
    for_each_node(grid, face, [&](int node) {
      Lanes& state = grid.state[node];
      if (!(state[0] > smallest_nodal_mass)) return;
      for (int axis = 0; axis < 3; ++axis) {
        if (only_tangential && axis == normal) continue;
        const double mass_speed = axis == normal ? state[7] : grid.updated[node][3];
        state[4 + axis] -= per_length * mass_speed * state[1 + axis] / state[0];
      }
    });
  }
}

std::vector<int> touched_nodes(const BackgroundGrid& grid, const CellIndex& cells) {
  std::vector<int> nodes;
  for (std::size_t b = 0; b < grid.bricks().size(); ++b) {
    for_each_cell(grid, static_cast<int>(b), cells.brick(static_cast<int>(b)),
                  [&](const Cell& cell, const int*, const int*, int) {
                    for (int n = 0; n < grid.nodes_per_cell(); ++n)
                      nodes.push_back(cell.first_node + grid.node_offsets()[n]);
                  });
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

Eigen::Vector3d override_velocity(BackgroundGrid& grid, const std::vector<int>& nodes,
                                  const Eigen::Vector3d& velocity, double dt) {
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();
  for (int node : nodes) {
    Lanes& state = grid.state[node];
    for (int axis = 0; axis < 3; ++axis) {
      const double jump = velocity[axis] - state[1 + axis];
      impulse[axis] += state[0] * jump;
      state[1 + axis] = velocity[axis];
      state[4 + axis] += jump / dt;
    }
  }
  return impulse;
}

void override_updated_velocity(BackgroundGrid& grid, const std::vector<int>& nodes,
                               const Eigen::Vector3d& velocity) {
  for (int node : nodes) {
    for (int axis = 0; axis < 3; ++axis) grid.updated[node][axis] = velocity[axis];
  }
}

}  // namespace zona::mpm
