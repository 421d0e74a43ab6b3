#pragma once

#include "mpm/grid/trilinear_batch.h"
#include "mpm/materials/prescribed.h"
#include "mpm/points/flatten.h"

namespace zona::mpm {

/// Records the points of a group that left their cells; cell_of(lane) is the number of a point's
/// cell in the brick.
template <class CellOf>
inline void record_departures(const PointGroup& group, const std::array<Lanes, 3>& natural,
                              CellOf cell_of, BrickPoints& points) {
  LaneMask outside{};
  for (int axis = 0; axis < 3; ++axis) {
    outside |= ~((natural[axis] >= 0.0) & (natural[axis] < 1.0));
  }
  if (!any(outside, group.count())) return;
  for (int l = 0; l < group.count(); ++l) {
    if (outside[l]) points.departures.push_back({group[l], cell_of(l)});
  }
}

/// Velocities and positions of a group of points at k+1, from the grid (3.34)-(3.37).
struct FreeMotion {
  /// Sets `velocity` [m/s] and advances `position` [m] to k+1, from the grid's `field` at the
  /// natural coordinates.
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

/// FreeMotion with a fraction of PIC: the grid's velocity at k+1 replaces that fraction of (3.37).
/// This conserves momentum, and damps rotation within a cell and motion that the grid cannot
/// represent.
struct BlendedMotion {
  double pic;  ///< fraction of PIC, 0 to 1

  /// Like FreeMotion.
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

/// Prescribed motion of a rigid body. Adds the momentum that this supplies to the points to
/// `impulse`.
struct PrescribedMotion {
  BlendedMotion unconstrained;  ///< motion of the points without the constraint
  Eigen::Vector3d& impulse;     ///< momentum supplied to the points [N s]

  /// Like FreeMotion.
  template <class CellField>
  void operator()(const Prescribed& material, MaterialPoints& points, const PointGroup& group,
                  const CellField& field, const std::array<Lanes, 3>& natural, double dt,
                  std::array<Lanes, 3>& velocity, std::array<Lanes, 3>& position) const {
    unconstrained(material, points, group, field, natural, dt, velocity, position);
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
ZONA_FLATTEN inline void gather_cell(Material& material, MaterialPoints& points, const Cell& cell,
                                     const int* begin, const int* end, int cell_in_brick, double dt,
                                     const Motion& motion, BrickPoints& brick_points,
                                     BackgroundGrid& grid) {
  const typename Shape::CellField field(grid, cell);
  typename Shape::VectorSums momentum(grid, cell);
  for_each_group(begin, end, [&](const PointGroup& group) {
    std::array<Lanes, 3> position = group.load(points.last_position);
    const auto natural = cell.natural(position);
    std::array<Lanes, 3> velocity;
    motion(material, points, group, field, natural, dt, velocity, position);
    group.store(points.velocity, velocity);
    group.store(points.position, position);
    record_departures(
        group, cell.natural(position), [=](int) { return cell_in_brick; }, brick_points);

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

/// Does the same for a batch of points from sparsely filled cells.
template <class Material, class Motion>
ZONA_FLATTEN inline void gather_batch(Material& material, MaterialPoints& points,
                                      const Batch& batch, double dt, const Motion& motion,
                                      BrickPoints& brick_points, BackgroundGrid& grid) {
  const PointGroup& group = batch.group;
  std::array<Lanes, 3> position = group.load(points.last_position);
  const auto natural = batch.natural(position);
  const trilinear::BatchWeights weights(batch, natural);
  const trilinear::BatchField field(grid, batch, weights);
  std::array<Lanes, 3> velocity;
  motion(material, points, group, field, natural, dt, velocity, position);
  group.store(points.velocity, velocity);
  group.store(points.position, position);
  record_departures(
      group, batch.natural(position), [&](int l) { return batch.cell[l]; }, brick_points);
  const Lanes mass = group.load(points.mass);
  trilinear::add_vectors(batch, weights,
                         {mass * velocity[0], mass * velocity[1], mass * velocity[2]}, grid);
}

}  // namespace zona::mpm
