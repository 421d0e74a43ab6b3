#pragma once

#include "mpm/prescribed.h"
#include "mpm/shape_functions.h"
#include "mpm/velocity_gradient.h"
#include "mpm/volume_average.h"

namespace zona::mpm {

/// Velocity and acceleration of the grid within one cell, as coefficients: [coefficient][field],
/// fields as in BackgroundGrid::state.
struct CellField {
  alignas(64) double c[8][lane_count];

  CellField(const BackgroundGrid& grid, const Cell& cell) {
    Lanes node[8];
    for (int n = 0; n < 8; ++n) node[n] = grid.state[cell.first_node + grid.node_offsets()[n]];
    trilinear::to_coefficients(node);
    for (int n = 0; n < 8; ++n) store(c[n], node[n]);
  }
  Lanes velocity(int axis, const std::array<Lanes, 3>& natural) const {
    return trilinear::interpolate(&c[0][1 + axis], lane_count, natural);
  }
  Lanes acceleration(int axis, const std::array<Lanes, 3>& natural) const {
    return trilinear::interpolate(&c[0][4 + axis], lane_count, natural);
  }
};

/// Lists the points of a group that left the cell.
inline void note_departures(const PointGroup& group, const std::array<Lanes, 3>& natural,
                            int cell_in_brick, BrickPoints& points) {
  LaneMask outside{};
  for (int axis = 0; axis < 3; ++axis) {
    outside |= ~((natural[axis] >= 0.0) & (natural[axis] < 1.0));
  }
  if (!any(outside, group.count())) return;
  for (int l = 0; l < group.count(); ++l) {
    if (outside[l]) points.departures.push_back({group[l], cell_in_brick});
  }
}

/// Velocities and positions at k+1 of a group of points, from the grid (3.34)-(3.37).
struct FreeMotion {
  template <class Material>
  void operator()(Material&, MaterialPoints& points, const PointGroup& group,
                  const CellField& field, const std::array<Lanes, 3>& natural, double dt,
                  std::array<Lanes, 3>& velocity, std::array<Lanes, 3>& position) const {
    for (int axis = 0; axis < 3; ++axis) {
      position[axis] += dt * field.velocity(axis, natural);
      velocity[axis] = group.load(points.velocity[axis]) + dt * field.acceleration(axis, natural);
    }
  }
};

/// FreeMotion with a fraction of PIC in the velocity: that of the grid at k+1 takes the place of
/// (3.37). Momentum is the same, motion that the grid does not see dies out, and so does rotation
/// within a cell.
struct BlendedMotion {
  double pic;

  template <class Material>
  void operator()(Material& material, MaterialPoints& points, const PointGroup& group,
                  const CellField& field, const std::array<Lanes, 3>& natural, double dt,
                  std::array<Lanes, 3>& velocity, std::array<Lanes, 3>& position) const {
    FreeMotion{}(material, points, group, field, natural, dt, velocity, position);
    for (int axis = 0; axis < 3; ++axis) {
      velocity[axis] += pic * (field.velocity(axis, natural) - velocity[axis]);
    }
  }
};

/// The prescribed motion of a rigid body; its points' momentum that has to be supplied to keep it
/// is added to `impulse` [N s].
struct PrescribedMotion {
  BlendedMotion unhindered;
  Eigen::Vector3d& impulse;

  void operator()(const Prescribed& material, MaterialPoints& points, const PointGroup& group,
                  const CellField& field, const std::array<Lanes, 3>& natural, double dt,
                  std::array<Lanes, 3>& velocity, std::array<Lanes, 3>& position) const {
    unhindered(material, points, group, field, natural, dt, velocity, position);
    const Lanes mass = group.load(points.mass);
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes prescribed = broadcast(material.next.velocity[axis]);
      const Lanes supplied = mass * (prescribed - velocity[axis]);
      for (int l = 0; l < group.count(); ++l) impulse[axis] += supplied[l];
      velocity[axis] = prescribed;
      position[axis] =
          group.load(material.initial_position[axis]) + material.next.displacement[axis];
    }
  }
};

/// Moves the points of one cell and maps their new momentum back to the nodes (3.34)-(3.38).
template <class Material, class Motion>
inline void gather_cell(Material& material, MaterialPoints& points, const Cell& cell,
                        const int* begin, const int* end, int cell_in_brick, double dt,
                        const Motion& motion, BrickPoints& brick_points, BackgroundGrid& grid) {
  const CellField field(grid, cell);
  Lanes momentum[8]{};
  for_each_group(begin, end, [&](const PointGroup& group) {
    std::array<Lanes, 3> position = group.load(points.position);
    const auto natural = cell.natural(position);
    std::array<Lanes, 3> velocity;
    motion(material, points, group, field, natural, dt, velocity, position);
    group.store(points.velocity, velocity);
    group.store(points.next_position, position);
    note_departures(group, cell.natural(position), cell_in_brick, brick_points);

    alignas(64) double at[6][lane_count];
    const Lanes mass = group.load(points.mass);
    for (int axis = 0; axis < 3; ++axis) {
      store(at[axis], natural[axis]);
      store(at[3 + axis], mass * velocity[axis]);
    }
    for (int p = 0; p < group.count(); ++p) {
      const auto n = trilinear::factors(at[0][p], at[1][p], at[2][p]);
      const Lanes shape = n.x * n.y * n.z;
      for (int axis = 0; axis < 3; ++axis) momentum[axis] += at[3 + axis][p] * shape;
    }
  });
  transpose(momentum);
  for (int n = 0; n < 8; ++n) {
    grid.updated[cell.first_node + grid.node_offsets()[n]] +=
        __builtin_shufflevector(momentum[n], momentum[n], 0, 1, 2, 3);
  }
}

/// Velocity gradient of the updated nodal velocities (3.40) at the points of one cell.
struct CellGradient {
  alignas(64) double c[8][4];
  std::array<double, 3> inverse;

  CellGradient(const BackgroundGrid& grid, const Cell& cell) : inverse(cell.inverse) {
    HalfLanes node[8];
    for (int n = 0; n < 8; ++n) node[n] = grid.updated[cell.first_node + grid.node_offsets()[n]];
    trilinear::to_coefficients(node);
    __builtin_memcpy(c, node, sizeof(c));
  }
  VelocityGradient at(const std::array<Lanes, 3>& natural) const {
    VelocityGradient gradient;
    for (int i = 0; i < 3; ++i) {
      gradient[i] = trilinear::derivatives(&c[0][i], 4, natural);
      for (int j = 0; j < 3; ++j) gradient[i][j] *= inverse[j];
    }
    return gradient;
  }
};

/// Mean divergence [1/s] over the points of a cell, by volume.
template <class Material>
inline double mean_divergence(const Material& material, const MaterialPoints& points,
                              const Cell& cell, const CellGradient& gradient, const int* begin,
                              const int* end) {
  return volume_average(material, points, begin, end, [&](const PointGroup& group) {
    return divergence(gradient.at(cell.natural(group.load(points.position))));
  });
}

}  // namespace zona::mpm
