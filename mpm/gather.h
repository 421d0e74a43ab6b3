#pragma once

#include "mpm/cell.h"
#include "mpm/prescribed.h"
#include "mpm/velocity_gradient.h"
#include "mpm/volume_average.h"

namespace zona::mpm {

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
  template <class Material, class CellField>
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

  template <class Material, class CellField>
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

  template <class CellField>
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
template <class Shape, class Material, class Motion>
[[gnu::flatten]] inline void gather_cell(Material& material, MaterialPoints& points,
                                         const Cell& cell, const int* begin, const int* end,
                                         int cell_in_brick, double dt, const Motion& motion,
                                         BrickPoints& brick_points, BackgroundGrid& grid) {
  const typename Shape::CellField field(grid, cell);
  typename Shape::VectorSums momentum(grid, cell);
  for_each_group(begin, end, [&](const PointGroup& group) {
    std::array<Lanes, 3> position = group.load(points.position);
    const auto natural = cell.natural(position);
    std::array<Lanes, 3> velocity;
    motion(material, points, group, field, natural, dt, velocity, position);
    group.store(points.velocity, velocity);
    group.store(points.next_position, position);
    note_departures(group, cell.natural(position), cell_in_brick, brick_points);

    PointVectors at;
    const Lanes mass = group.load(points.mass);
    for (int axis = 0; axis < 3; ++axis) {
      store(at.natural[axis], natural[axis]);
      store(at.vector[axis], mass * velocity[axis]);
    }
    for (int p = 0; p < group.count(); ++p) momentum.add(at, p);
  });
  momentum.for_each_node(cell, grid,
                         [&](int node, const HalfLanes& sum) { grid.updated[node] += sum; });
}

/// Mean divergence [1/s] over the points of a cell, by volume.
template <class Material, class CellGradient>
inline double mean_divergence(const Material& material, const MaterialPoints& points,
                              const Cell& cell, const CellGradient& gradient, const int* begin,
                              const int* end) {
  return volume_average(material, points, begin, end, [&](const PointGroup& group) {
    return divergence(gradient.at(cell.natural(group.load(points.position))));
  });
}

/// Strains the points of one cell and updates their stress (3.40)-(3.42), with their mean
/// volumetric strain rate if `averaged`. Adds to `bad` the points whose state lost its meaning.
template <class Shape, bool averaged, class Material>
[[gnu::flatten]] inline void update_cell(Material& material, const MaterialPoints& points,
                                         const Cell& cell, const int* begin, const int* end,
                                         double dt, const BackgroundGrid& grid,
                                         std::vector<int>& bad) {
  const double length = grid.characteristic_length();
  const typename Shape::CellGradient gradient(grid, cell);
  double mean = 0;
  if constexpr (averaged) mean = mean_divergence(material, points, cell, gradient, begin, end);
  for_each_group(begin, end, [&](const PointGroup& group) {
    VelocityGradient l = gradient.at(cell.natural(group.load(points.position)));
    if constexpr (averaged) l = with_divergence(l, mean);
    const LaneMask failed = material.update(group, l, dt, length);
    if (!any(failed, group.count())) return;
    for (int lane = 0; lane < group.count(); ++lane) {
      if (failed[lane]) bad.push_back(group[lane]);
    }
  });
}

}  // namespace zona::mpm
