#pragma once

#include "mpm/bodies/fluid_cells.h"
#include "mpm/grid/trilinear_batch.h"
#include "mpm/points/flatten.h"
#include "mpm/points/velocity_gradient.h"
#include "mpm/points/volume_average.h"

namespace zona::mpm {

/// Volumetric strain rate and mean stress of the points of a cell.
enum class Volumetric {
  own,       ///< each point's
  averaged,  ///< their means (Body::average_volume_strain)
  implicit   ///< of the cell's implicit pressure, which acts beside the points (FluidCells)
};

/// Stress that acts on the nodes [Pa]: the points' own, or their deviators plus the mean stress of
/// the cell, zero where that acts beside the points.
template <Volumetric kind, class Material>
inline SymmetricTensorLanes acting_stress(const Material& material, const PointGroup& group,
                                          double mean_stress) {
  SymmetricTensorLanes sigma = group.load(material.stress);
  if constexpr (kind != Volumetric::own) {
    const Lanes change = mean_stress - trace(sigma) / 3.0;
    for (int i = 0; i < 3; ++i) sigma[i] += change;
  }
  return sigma;
}

/// Contributions of a group of points to the nodes; `place` is its Cell or Batch.
template <Volumetric kind, class Place, class Material>
inline PointContributions contributions_of(const Material& material, const MaterialPoints& points,
                                           const PointGroup& group, const Place& place,
                                           double mean_stress) {
  PointContributions to_nodes;
  const auto natural = place.natural(group.load(points.position));
  const Lanes mass = group.load(points.mass);
  store(to_nodes.mass, mass);
  for (int i = 0; i < 3; ++i) {
    store(to_nodes.natural[i], natural[i]);
    store(to_nodes.momentum[i], mass * group.load(points.velocity[i]));
  }
  if constexpr (Material::has_stress) {
    const Lanes volume = material.volume(group, mass);
    const SymmetricTensorLanes sigma = acting_stress<kind>(material, group, mean_stress);
    constexpr int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    for (int j = 0; j < 3; ++j) {
      const Lanes scale = -place.inverse[j] * volume;
      for (int i = 0; i < 3; ++i) store(to_nodes.stress[i][j], sigma[component[i][j]] * scale);
    }
  }
  return to_nodes;
}

/// Adds mass (3.30), momentum (3.31) and internal force (3.32) of a group of points of a cell.
template <Volumetric kind, class NodalSums, class Material>
inline void add_points(const Material& material, const MaterialPoints& points,
                       const PointGroup& group, const Cell& cell, double mean_stress,
                       NodalSums& sums) {
  const PointContributions to_nodes =
      contributions_of<kind>(material, points, group, cell, mean_stress);
  for (int p = 0; p < group.count(); ++p) sums.template add<Material::has_stress>(to_nodes, p);
}

/// Scatters the points of one cell to its nodes. Averaged points act with their mean
/// spherical stress. This is conjugate to their mean volumetric strain rate (see Body): the forces
/// do the same work as the stresses.
template <class Shape, Volumetric kind, class Material>
ZONA_FLATTEN inline void scatter_cell(const Material& material, const MaterialPoints& points,
                                      const Cell& cell, const int* begin, const int* end,
                                      BackgroundGrid& grid) {
  typename Shape::NodalSums sums(grid, cell);
  double mean_stress = 0;
  if constexpr (kind == Volumetric::averaged) {
    mean_stress = volume_average(material, points, begin, end, [&](const PointGroup& group) {
      return trace(group.load(material.stress)) / 3.0;
    });
  }
  for_each_group(begin, end, [&](const PointGroup& group) {
    add_points<kind>(material, points, group, cell, mean_stress, sums);
  });
  sums.add_to_nodes(cell, material.wave_speed(), material.shear_wave_speed(), grid);
}

/// Adds a group of points of a fluid with implicit pressure to the sums of a cell.
template <class NodalSums>
inline void add_fluid_points(const Fluid& fluid, const MaterialPoints& points,
                             const PointGroup& group, const Cell& cell, NodalSums& sums,
                             CellSummation& cell_sums) {
  const PointContributions to_nodes =
      contributions_of<Volumetric::implicit>(fluid, points, group, cell, 0);
  if (fluid.properties.shear_viscosity > 0) {
    for (int p = 0; p < group.count(); ++p) sums.template add<true>(to_nodes, p);
  } else {
    for (int p = 0; p < group.count(); ++p) sums.template add<false>(to_nodes, p);
  }
  cell_sums.add(fluid, points, group,
                {load(to_nodes.natural[0]), load(to_nodes.natural[1]), load(to_nodes.natural[2])});
}

/// Scatters the points of one cell of a fluid with implicit pressure; returns the cell's sums.
template <class Shape>
ZONA_FLATTEN inline FluidSums scatter_fluid_cell(const Fluid& fluid, const MaterialPoints& points,
                                                 const Cell& cell, const int* begin, const int* end,
                                                 BackgroundGrid& grid) {
  typename Shape::NodalSums sums(grid, cell);
  CellSummation cell_sums;
  for_each_group(begin, end, [&](const PointGroup& group) {
    add_fluid_points(fluid, points, group, cell, sums, cell_sums);
  });
  sums.add_to_nodes(cell, fluid.wave_speed(), fluid.shear_wave_speed(), grid);
  return cell_sums.sums();
}

/// Does the same for a batch of points from sparsely filled cells, without averages.
template <class Material>
ZONA_FLATTEN inline void scatter_batch(const Material& material, const MaterialPoints& points,
                                       const Batch& batch, BackgroundGrid& grid) {
  const PointContributions to_nodes =
      contributions_of<Volumetric::own>(material, points, batch.group, batch, 0);
  trilinear::add_to_nodes<Material::has_stress>(batch, to_nodes, material.wave_speed(),
                                                material.shear_wave_speed(), grid);
}

}  // namespace zona::mpm
