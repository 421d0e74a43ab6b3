#pragma once

#include "mpm/grid/batch.h"
#include "mpm/grid/trilinear.h"

namespace zona::mpm::trilinear {

/// Shape functions of each point of a batch at the nodes of its cell: [point][node].
struct BatchWeights {
  alignas(64) double at[lane_count][8];  ///< [-]

  /// Values at natural coordinates in [0, 1].
  BatchWeights(const Batch& batch, const std::array<Lanes, 3>& natural) {
    for (int p = 0; p < batch.group.count(); ++p) {
      const auto n = factors(natural[0][p], natural[1][p], natural[2][p]);
      store(at[p], n.x * (n.y * n.z));
    }
  }
};

/// Shape functions of one point and their derivatives with respect to the natural coordinates.
struct PointWeights {
  alignas(64) double value[8];     ///< of each node [-]
  alignas(64) double slope[3][8];  ///< by each coordinate, of each node [-]

  /// Values for point p of eight points at natural coordinates in [0, 1].
  PointWeights(const std::array<Lanes, 3>& natural, int p) {
    const auto n = factors(natural[0][p], natural[1][p], natural[2][p]);
    const Lanes yz = n.y * n.z;
    store(value, n.x * yz);
    store(slope[0], sign_x * yz);
    store(slope[1], sign_y * (n.x * n.z));
    store(slope[2], sign_z * (n.x * n.y));
  }
};

/// Velocity and acceleration of the grid at the points of a batch, like CellField.
class BatchField {
 public:
  /// Sums over the nodes of each point.
  BatchField(const BackgroundGrid& grid, const Batch& batch, const BatchWeights& weights) {
    const auto& offset = grid.node_offsets();
    for (int p = 0; p < batch.group.count(); ++p) {
      const Lanes* first = &grid.state[batch.node[p]];
      const double* w = weights.at[p];
      for (int n = 0; n < 8; ++n) row_[p] += w[n] * first[offset[n]];
    }
    transpose(row_);
  }
  /// @{
  /// Velocity [m/s] or acceleration [m/s^2] of the points; the coordinates are not needed again.
  Lanes velocity(int axis, const std::array<Lanes, 3>&) const { return row_[1 + axis]; }
  Lanes acceleration(int axis, const std::array<Lanes, 3>&) const { return row_[4 + axis]; }
  /// @}

 private:
  Lanes row_[8]{};
};

/// Adds a vector of each point of a batch to the updated momentum of the nodes.
inline void add_vectors(const Batch& batch, const BatchWeights& weights,
                        const std::array<Lanes, 3>& vector, BackgroundGrid& grid) {
  Lanes row[8]{vector[0], vector[1], vector[2]};
  transpose(row);
  const auto& offset = grid.node_offsets();
  for (int p = 0; p < batch.group.count(); ++p) {
    HalfLanes* first = &grid.updated[batch.node[p]];
    const double* w = weights.at[p];
    const HalfLanes v = low_half(row[p]);
    for (int n = 0; n < 8; ++n) first[offset[n]] += w[n] * v;
  }
}

/// Velocity gradient of the updated nodal velocities (3.40) at the points of a batch.
inline VelocityGradient gradient_at(const BackgroundGrid& grid, const Batch& batch,
                                    const std::array<Lanes, 3>& natural) {
  const auto& offset = grid.node_offsets();
  Lanes xy[8]{};  // per point d/dxi of the velocity, then d/deta
  Lanes z[8]{};
  for (int p = 0; p < batch.group.count(); ++p) {
    const PointWeights w(natural, p);
    const HalfLanes* first = &grid.updated[batch.node[p]];
    HalfLanes d[3]{};
    for (int n = 0; n < 8; ++n) {
      const HalfLanes v = first[offset[n]];
      for (int j = 0; j < 3; ++j) d[j] += w.slope[j][n] * v;
    }
    xy[p] = join(d[0], d[1]);
    z[p] = join(d[2], d[2]);
  }
  transpose(xy);
  transpose(z);
  VelocityGradient gradient;
  for (int i = 0; i < 3; ++i) {
    gradient[i] = {xy[i] * batch.inverse[0], xy[4 + i] * batch.inverse[1], z[i] * batch.inverse[2]};
  }
  return gradient;
}

/// Adds mass, momentum and internal force of the points of a batch to the nodes, like NodalSums.
template <bool with_stress>
void add_to_nodes(const Batch& batch, const PointContributions& points, double wave_speed,
                  double shear_wave_speed, BackgroundGrid& grid) {
  const Lanes mass = load(points.mass);
  Lanes carried[8]{mass, load(points.momentum[0]), load(points.momentum[1]),
                   load(points.momentum[2])};
  carried[7] = wave_speed * mass;
  transpose(carried);
  Lanes stress[3][8]{};
  if constexpr (with_stress) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) stress[j][4 + i] = load(points.stress[i][j]);
      transpose(stress[j]);
    }
  }
  const std::array<Lanes, 3> natural{load(points.natural[0]), load(points.natural[1]),
                                     load(points.natural[2])};
  const auto& offset = grid.node_offsets();
  for (int p = 0; p < batch.group.count(); ++p) {
    const PointWeights w(natural, p);
    Lanes* first = &grid.state[batch.node[p]];
    for (int n = 0; n < 8; ++n) {
      Lanes sum = first[offset[n]] + w.value[n] * carried[p];
      if constexpr (with_stress) {
        for (int j = 0; j < 3; ++j) sum += w.slope[j][n] * stress[j][p];
      }
      first[offset[n]] = sum;
    }
    if (shear_wave_speed > 0) {
      for (int n = 0; n < 8; ++n)
        grid.updated[batch.node[p] + offset[n]][3] +=
            shear_wave_speed * w.value[n] * points.mass[p];
    }
  }
}

}  // namespace zona::mpm::trilinear
