#pragma once

#include "mpm/shape_functions.h"
#include "mpm/velocity_gradient.h"
#include "mpm/volume_average.h"

namespace zona::mpm {

/// Sums over the points of a cell that go to its eight nodes, in registers.
struct NodalSums {
  Lanes mass{};
  Lanes momentum[3]{};
  Lanes force_x[3]{};  ///< stress terms with dN/dxi: still to be multiplied by the node's sign
  Lanes force_y[3]{};  ///< with dN/deta
  Lanes force_z[3]{};  ///< with dN/dzeta

  /// Nodes' rows of mass, momentum, force, and mass times `wave_speed`.
  void rows(double wave_speed, Lanes (&row)[8]) const {
    row[0] = mass;
    for (int i = 0; i < 3; ++i) {
      row[1 + i] = momentum[i];
      row[4 + i] = trilinear::sign_x * force_x[i] + trilinear::sign_y * force_y[i] +
                   trilinear::sign_z * force_z[i];
    }
    row[7] = wave_speed * mass;
    transpose(row);
  }
};

/// What a group of points brings to the nodes, one row per quantity, a column per point.
struct PointLoads {
  alignas(64) double natural[3][lane_count];
  alignas(64) double mass[lane_count];
  alignas(64) double momentum[3][lane_count];
  alignas(64) double stress[3][3][lane_count];  ///< -volume sigma_ij / cell size_j [N]
};

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

template <bool averaged, class Material>
inline void load_stress(const Material& material, const PointGroup& group, const Cell& cell,
                        const Lanes& mass, double mean_stress, PointLoads& loads) {
  const Lanes volume = material.volume(group, mass);
  const SymmetricTensorLanes sigma = acting_stress<averaged>(material, group, mean_stress);
  constexpr int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  for (int j = 0; j < 3; ++j) {
    const Lanes scale = -cell.inverse[j] * volume;
    for (int i = 0; i < 3; ++i) store(loads.stress[i][j], sigma[component[i][j]] * scale);
  }
}

/// Adds mass (3.30), momentum (3.31) and internal force (3.32) of a group of points.
template <bool averaged, class Material>
inline void add_points(const Material& material, const MaterialPoints& points,
                       const PointGroup& group, const Cell& cell, double mean_stress,
                       NodalSums& sums) {
  PointLoads loads;
  const auto natural = cell.natural(group.load(points.position));
  const Lanes mass = group.load(points.mass);
  store(loads.mass, mass);
  for (int i = 0; i < 3; ++i) {
    store(loads.natural[i], natural[i]);
    store(loads.momentum[i], mass * group.load(points.velocity[i]));
  }
  if constexpr (Material::has_stress)
    load_stress<averaged>(material, group, cell, mass, mean_stress, loads);

  for (int p = 0; p < group.count(); ++p) {
    const auto n =
        trilinear::factors(loads.natural[0][p], loads.natural[1][p], loads.natural[2][p]);
    const Lanes yz = n.y * n.z;
    const Lanes shape = n.x * yz;
    sums.mass += loads.mass[p] * shape;
    for (int i = 0; i < 3; ++i) sums.momentum[i] += loads.momentum[i][p] * shape;
    if constexpr (Material::has_stress) {
      const Lanes xz = n.x * n.z;
      const Lanes xy = n.x * n.y;
      for (int i = 0; i < 3; ++i) {
        sums.force_x[i] += loads.stress[i][0][p] * yz;
        sums.force_y[i] += loads.stress[i][1][p] * xz;
        sums.force_z[i] += loads.stress[i][2][p] * xy;
      }
    }
  }
}

/// Scatters the points of one cell to its nodes. With `averaged` the points of the cell push with
/// their mean spherical stress: what goes with their mean volumetric strain rate, see Body, so that
/// the work of the forces is the work of the stresses.
template <bool averaged, class Material>
inline void scatter_cell(const Material& material, const MaterialPoints& points, const Cell& cell,
                         const int* begin, const int* end, BackgroundGrid& grid) {
  NodalSums sums;
  double mean_stress = 0;
  if constexpr (averaged) {
    mean_stress = volume_average(material, points, begin, end, [&](const PointGroup& group) {
      return trace(group.load(material.stress)) / 3.0;
    });
  }
  for_each_group(begin, end, [&](const PointGroup& group) {
    add_points<averaged>(material, points, group, cell, mean_stress, sums);
  });
  if (const double shear = material.shear_wave_speed(); shear > 0) {
    for (int n = 0; n < 8; ++n) {
      grid.updated[cell.first_node + grid.node_offsets()[n]][3] += shear * sums.mass[n];
    }
  }
  Lanes row[8];
  sums.rows(material.wave_speed(), row);
  for (int n = 0; n < 8; ++n) grid.state[cell.first_node + grid.node_offsets()[n]] += row[n];
}

}  // namespace zona::mpm
