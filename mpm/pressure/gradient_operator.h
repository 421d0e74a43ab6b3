#pragma once

#include "mpm/bodies/fluid_cells.h"
#include "mpm/pressure/lattice_loop.h"

namespace zona::mpm {

/// Sums over the points of cells of volume times gradient of the shape functions [m^2], for one
/// fluid. They turn pressures of cells into forces on nodes, and velocities of nodes into rates of
/// change of the cells' volumes; both are transposes of each other to the last bit.
///
/// A cell has four numbers per axis: the derivatives along it of the nodes at its far end, which
/// the nodes at its near end have with the opposite sign. No pressure therefore moves the centre of
/// mass. Single precision halves the traffic; rounding is the same in both directions.
class GradientOperator {
 public:
  /// All zero.
  explicit GradientOperator(const CellLattice& lattice);

  /// Sets the numbers of the cell at a place; `inverse` has 1 / cell size along each axis [1/m].
  void set(long place, const FluidSums& sums, const std::array<double, 3>& inverse);

  /// Sets `force` to the forces [N] of pressures p [Pa] on the nodes of a chunk, or adds them.
  template <bool add, class Real>
  void forces(const Real* p, const Chunk& chunk, const std::array<Real*, 3>& force) const;
  /// Sets `expansion` to the rates of change of the volumes of the chunk's cells [m^3/s] at nodal
  /// velocities [m/s].
  template <class Real>
  void expand(const std::array<const Real*, 3>& velocity, const Chunk& chunk,
              Real* expansion) const;
  /// Adds G M^-1 G^T of single cells to `diagonal`, with the mobilities of the nodes [1/kg].
  void add_diagonal(const std::array<FloatField, 3>& mobility, const Chunk& chunk,
                    float* diagonal) const;
  /// The number of the cell at a place for an axis and its corner 0 to 3.
  float at(int axis, int corner, long place) const { return corner_[4 * axis + corner][place]; }

  /// Steps on the lattice: along an axis and along the two others, in ascending order.
  struct Steps {
    long along;   ///< to the next place along the axis
    long first;   ///< along the first of the two others
    long second;  ///< along the second

    /// From a cell to its corner 0 to 3, a node at the near end.
    long to(int corner) const { return corner % 2 * first + corner / 2 * second; }
  };
  /// Those of an axis.
  Steps steps(int axis) const {
    const long step[3] = {1, row_, layer_};
    return {step[axis], step[axis == 0 ? 1 : 0], step[axis == 2 ? 1 : 2]};
  }

 private:
  long row_;
  long layer_;
  std::array<FloatField, 12> corner_;
};

template <bool add, class Real>
void GradientOperator::forces(const Real* p, const Chunk& chunk,
                              const std::array<Real*, 3>& force) const {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [along, u, w] = steps(axis);
    const float* g00 = corner_[4 * axis].data();
    const float* g10 = corner_[4 * axis + 1].data();
    const float* g01 = corner_[4 * axis + 2].data();
    const float* g11 = corner_[4 * axis + 3].data();
    Real* f = force[axis];
#pragma omp simd
    for (long n = chunk.begin; n < chunk.end; ++n) {
      const long b = n - along;
      const Real sum = (g00[b] * p[b] - g00[n] * p[n]) +
                       (g10[b - u] * p[b - u] - g10[n - u] * p[n - u]) +
                       (g01[b - w] * p[b - w] - g01[n - w] * p[n - w]) +
                       (g11[b - u - w] * p[b - u - w] - g11[n - u - w] * p[n - u - w]);
      f[n] = add ? f[n] + sum : sum;
    }
  }
}

template <class Real>
void GradientOperator::expand(const std::array<const Real*, 3>& velocity, const Chunk& chunk,
                              Real* expansion) const {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [along, u, w] = steps(axis);
    const float* g00 = corner_[4 * axis].data();
    const float* g10 = corner_[4 * axis + 1].data();
    const float* g01 = corner_[4 * axis + 2].data();
    const float* g11 = corner_[4 * axis + 3].data();
    const Real* v = velocity[axis];
#pragma omp simd
    for (long c = chunk.begin; c < chunk.end; ++c) {
      const long e = c + along;
      const Real sum = g00[c] * (v[e] - v[c]) + g10[c] * (v[e + u] - v[c + u]) +
                       g01[c] * (v[e + w] - v[c + w]) + g11[c] * (v[e + u + w] - v[c + u + w]);
      expansion[c] = axis == 0 ? sum : expansion[c] + sum;
    }
  }
}

}  // namespace zona::mpm
