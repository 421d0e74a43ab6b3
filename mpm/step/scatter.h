#pragma once

#include "mpm/grid/trilinear_batch.h"
#include "mpm/points/flatten.h"
#include "mpm/points/velocity_gradient.h"
#include "mpm/points/volume_average.h"

namespace zona::mpm {

/// Stress as it acts on the nodes: that of the points, or their deviators with the mean stress of
/// the cell [Pa].
template <bool averaged, class Material>
inline SymmetricTensorLanes acting_stress(const Material& material, const PointGroup& group,
                                          double mean_stress) {
  SymmetricTensorLanes sigma = group.load(material.stress);
  if constexpr (averaged) {
    const Lanes change = mean_stress - trace(sigma) / 3.0;
    for (int i = 0; i < 3; ++i) sigma[i] += change;
  }
  return sigma;
}

/// What a group of points brings to the nodes; `place` is the Cell or Batch that it lies in.
template <bool averaged, class Place, class Material>
inline PointLoads loads_of(const Material& material, const MaterialPoints& points,
                           const PointGroup& group, const Place& place, double mean_stress) {
  PointLoads loads;
  const auto natural = place.natural(group.load(points.position));
  const Lanes mass = group.load(points.mass);
  store(loads.mass, mass);
  for (int i = 0; i < 3; ++i) {
    store(loads.natural[i], natural[i]);
    store(loads.momentum[i], mass * group.load(points.velocity[i]));
  }
  if constexpr (Material::has_stress) {
    const Lanes volume = material.volume(group, mass);
    const SymmetricTensorLanes sigma = acting_stress<averaged>(material, group, mean_stress);
    constexpr int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    for (int j = 0; j < 3; ++j) {
      const Lanes scale = -place.inverse[j] * volume;
      for (int i = 0; i < 3; ++i) store(loads.stress[i][j], sigma[component[i][j]] * scale);
    }
  }
  return loads;
}

/// Adds mass (3.30), momentum (3.31) and internal force (3.32) of a group of points of a cell.
template <bool averaged, class NodalSums, class Material>
inline void add_points(const Material& material, const MaterialPoints& points,
                       const PointGroup& group, const Cell& cell, double mean_stress,
                       NodalSums& sums) {
  const PointLoads loads = loads_of<averaged>(material, points, group, cell, mean_stress);
  for (int p = 0; p < group.count(); ++p) sums.template add<Material::has_stress>(loads, p);
}

/// Scatters the points of one cell to its nodes. With `averaged` the points of the cell push with
/// their mean spherical stress: what goes with their mean volumetric strain rate, see Body, so that
/// the work of the forces is the work of the stresses.
template <class Shape, bool averaged, class Material>
ZONA_FLATTEN inline void scatter_cell(const Material& material, const MaterialPoints& points,
                                      const Cell& cell, const int* begin, const int* end,
                                      BackgroundGrid& grid) {
  typename Shape::NodalSums sums(grid, cell);
  double mean_stress = 0;
  if constexpr (averaged) {
    mean_stress = volume_average(material, points, begin, end, [&](const PointGroup& group) {
      return trace(group.load(material.stress)) / 3.0;
    });
  }
  for_each_group(begin, end, [&](const PointGroup& group) {
    add_points<averaged>(material, points, group, cell, mean_stress, sums);
  });
  sums.add_to_nodes(cell, material.wave_speed(), material.shear_wave_speed(), grid);
}

/// The same for a batch of points of cells with few, without averages.
template <class Material>
ZONA_FLATTEN inline void scatter_batch(const Material& material, const MaterialPoints& points,
                                       const Batch& batch, BackgroundGrid& grid) {
  const PointLoads loads = loads_of<false>(material, points, batch.group, batch, 0);
  trilinear::add_to_nodes<Material::has_stress>(batch, loads, material.wave_speed(),
                                                material.shear_wave_speed(), grid);
}

}  // namespace zona::mpm
