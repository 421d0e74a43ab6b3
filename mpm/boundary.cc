#include "mpm/boundary.h"

#include <algorithm>

namespace zona::mpm {

namespace {

/// Calls f(node, axis) for every velocity component that the faces hold.
template <class F>
void for_each_held(const BackgroundGrid& grid, const FaceConditions& faces, F f) {
  const auto& n = grid.nodes_along();
  for (int face = 0; face < 6; ++face) {
    const int normal = face / 2;
    const int u = (normal + 1) % 3;
    const int w = (normal + 2) % 3;
    std::array<int, 3> at{};
    at[normal] = face % 2 == 0 ? 0 : n[normal] - 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (!holds(faces[face], normal, axis)) continue;
      for (at[u] = 0; at[u] < n[u]; ++at[u]) {
        for (at[w] = 0; at[w] < n[w]; ++at[w]) f(grid.node_index(at[0], at[1], at[2]), axis);
      }
    }
  }
}

}  // namespace

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

bool absorption_rate(const BackgroundGrid& grid, const FaceConditions& faces,
                     const std::array<int, 3>& index, double wave_speed, double shear_wave_speed,
                     AbsorptionRate& rate) {
  rate = {0, 0, 0};
  bool absorbs = false;
  for (int face = 0; face < 6; ++face) {
    const int normal = face / 2;
    const int last = face % 2 == 0 ? 0 : grid.cells()[normal] - 1;
    if (faces[face] != FaceCondition::absorbing || index[normal] != last) continue;
    absorbs = true;
    for (int axis = 0; axis < 3; ++axis) {
      rate[axis] += (axis == normal ? wave_speed : shear_wave_speed) / grid.cell_size()[normal];
    }
  }
  return absorbs;
}

std::vector<int> touched_nodes(const BackgroundGrid& grid, const CellIndex& cells) {
  std::vector<int> nodes;
  for (std::size_t b = 0; b < grid.bricks().size(); ++b) {
    for_each_cell(grid, static_cast<int>(b), cells.brick(static_cast<int>(b)),
                  [&](const Cell& cell, const int*, const int*, int) {
                    for (int offset : grid.node_offsets()) nodes.push_back(cell.first_node + offset);
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
