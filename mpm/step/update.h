#pragma once

#include "mpm/points/flatten.h"
#include "mpm/step/scatter.h"

namespace zona::mpm {

/// Volume-weighted mean divergence [1/s] over the points of a cell.
template <class Material, class CellGradient>
inline double mean_divergence(const Material& material, const MaterialPoints& points,
                              const Cell& cell, const CellGradient& gradient, const int* begin,
                              const int* end) {
  return volume_average(material, points, begin, end, [&](const PointGroup& group) {
    return divergence(gradient.at(cell.natural(group.load(points.last_position))));
  });
}

/// Updates a group of points (3.40)-(3.42). Adds points with an invalid state to `invalid`.
template <class Material>
inline void update_points(Material& material, const PointGroup& group,
                          const VelocityGradient& gradient, double dt, double length,
                          std::vector<int>& invalid) {
  const LaneMask failed = material.update(group, gradient, dt, length);
  if (!any(failed, group.count())) return;
  for (int lane = 0; lane < group.count(); ++lane) {
    if (failed[lane]) invalid.push_back(group[lane]);
  }
}

/// Updates the points of one cell with the gradients at their last positions, and with their mean
/// volumetric strain rate if that is averaged; that of an implicit pressure is
/// `mean` [1/s].
template <class Shape, Volumetric kind, class Material>
ZONA_FLATTEN inline void update_cell(Material& material, const MaterialPoints& points,
                                     const Cell& cell, const int* begin, const int* end, double dt,
                                     double mean, const BackgroundGrid& grid,
                                     std::vector<int>& invalid) {
  const double length = grid.characteristic_length();
  const typename Shape::CellGradient gradient(grid, cell);
  if constexpr (kind == Volumetric::averaged)
    mean = mean_divergence(material, points, cell, gradient, begin, end);
  for_each_group(begin, end, [&](const PointGroup& group) {
    VelocityGradient l = gradient.at(cell.natural(group.load(points.last_position)));
    if constexpr (kind != Volumetric::own) l = with_divergence(l, mean);
    update_points(material, group, l, dt, length, invalid);
  });
}

/// Does update_cell and then scatter_cell at the new positions, loading each point once. No point
/// may have entered or left the cell.
template <class Shape, class Material>
ZONA_FLATTEN inline void update_and_scatter_cell(Material& material, const MaterialPoints& points,
                                                 const Cell& cell, const int* begin, const int* end,
                                                 double dt, BackgroundGrid& grid,
                                                 std::vector<int>& invalid) {
  const double length = grid.characteristic_length();
  const typename Shape::CellGradient gradient(grid, cell);
  typename Shape::NodalSums sums(grid, cell);
  for_each_group(begin, end, [&](const PointGroup& group) {
    const VelocityGradient l = gradient.at(cell.natural(group.load(points.last_position)));
    update_points(material, group, l, dt, length, invalid);
    add_points<Volumetric::own>(material, points, group, cell, 0, sums);
  });
  sums.add_to_nodes(cell, material.wave_speed(), material.shear_wave_speed(), grid);
}

/// Does the same for a cell of a fluid with implicit pressure; returns the cell's sums.
template <class Shape>
ZONA_FLATTEN inline FluidSums update_and_scatter_fluid_cell(
    Fluid& fluid, const MaterialPoints& points, const Cell& cell, const int* begin, const int* end,
    double dt, double mean, BackgroundGrid& grid, std::vector<int>& invalid) {
  const double length = grid.characteristic_length();
  const typename Shape::CellGradient gradient(grid, cell);
  typename Shape::NodalSums sums(grid, cell);
  CellSummation cell_sums;
  for_each_group(begin, end, [&](const PointGroup& group) {
    const VelocityGradient l = gradient.at(cell.natural(group.load(points.last_position)));
    update_points(fluid, group, with_divergence(l, mean), dt, length, invalid);
    add_fluid_points(fluid, points, group, cell, sums, cell_sums);
  });
  sums.add_to_nodes(cell, fluid.wave_speed(), fluid.shear_wave_speed(), grid);
  return cell_sums.sums();
}

/// Does the same for a batch of points from sparsely filled cells.
template <class Material>
ZONA_FLATTEN inline void update_and_scatter_batch(Material& material, const MaterialPoints& points,
                                                  const Batch& batch, double dt,
                                                  BackgroundGrid& grid, std::vector<int>& invalid) {
  const auto natural = batch.natural(batch.group.load(points.last_position));
  update_points(material, batch.group, trilinear::gradient_at(grid, batch, natural), dt,
                grid.characteristic_length(), invalid);
  scatter_batch(material, points, batch, grid);
}

}  // namespace zona::mpm
