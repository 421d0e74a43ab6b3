#pragma once

#include <utility>
#include <vector>

#include "mpm/pressure/gradient_operator.h"
#include "mpm/pressure/multigrid.h"

namespace zona::mpm {

/// The linear system for the pressures q of all fluids in all cells,
///
///     C q + G M^-1 G^T q = b,
///
/// symmetric and positive definite: volume that a pressure takes by compression, and by moving the
/// nodes, over the square of the step. Conjugate gradients solve it; the preconditioner is the
/// diagonal, for short waves, plus multigrid for the sum of all fluids, for long ones. Corrections
/// are computed in single precision and their residuals in double, so that the residual reaches any
/// tolerance.
///
/// The eight nodes of a cell do not see some alternating pressures of its neighbours: these have
/// next to no weight in the residual, and next to no effect on the nodes.
class PressureSystem {
 public:
  /// Coefficients and unknowns of one fluid, per place of the lattice.
  struct Fluid {
    explicit Fluid(const CellLattice& lattice);  ///< All zero.

    GradientOperator gradient;         ///< G
    Field compliance;                  ///< C [m^3/(Pa s^2)]; zero in cells without the fluid
    Field right;                       ///< b [m^3/s^2]
    Field pressure;                    ///< q [Pa]; zero in cells without the fluid
    std::vector<char> occupied_chunk;  ///< per chunk of the lattice: some cell has the fluid
  };

  /// For a number of fluids; all calls use this number of threads.
  PressureSystem(const CellLattice& lattice, std::size_t fluids, int threads);

  std::vector<Fluid> fluids;           ///< to be set before `solve`
  std::array<FloatField, 3> mobility;  ///< M^-1 of the nodes, velocity per impulse [1/kg]

  /// Outcome of a solve.
  struct Outcome {
    int iterations;   ///< of conjugate gradients
    double residual;  ///< its norm over the given one
    bool converged;   ///< residual within the tolerance
  };
  /// Solves for the pressures, starting from those that stand, until the norm of the residual is at
  /// most `tolerance` times the larger of `norm` and the residual at the start [m^3/s^2], or below
  /// `negligible`.
  Outcome solve(double norm, double tolerance, double negligible = 0);

  /// Fluid and place of the cell with the largest residual of the last solve.
  std::pair<std::size_t, long> worst_cell() const;
  /// Forces of the pressures on the nodes [N].
  const std::array<Field, 3>& forces();

 private:
  /// Vectors of conjugate gradients, of one fluid.
  struct Work {
    explicit Work(const CellLattice& lattice);

    FloatField compliance, inverse_diagonal, residual, preconditioned, product, search, correction;
  };

  /// Calls f(Work, Fluid) for the fluids with cells in a chunk.
  template <class F>
  void for_occupied(const Chunk& chunk, F f) {
    for (std::size_t i = 0; i < fluids.size(); ++i) {
      if (fluids[i].occupied_chunk[chunk.number]) f(work_[i], fluids[i]);
    }
  }
  template <class Real>
  void set_forces(const std::vector<const Real*>& pressures, const Chunk& chunk,
                  const std::array<Real*, 3>& force) const;
  bool reaches(const Fluid& fluid, const Chunk& chunk) const;
  double set_residual();
  void set_preconditioner();
  double precondition();
  void move_nodes();
  void multiply(const Fluid& fluid, Work& work, const Chunk& chunk) const;
  void sum_residuals(const Chunk& chunk);
  int reduce(double enough, int most_iterations);
  static void advance(Work& work, const Chunk& chunk, float length);

  CellLattice lattice_;
  LatticeLoop loop_;
  int threads_;
  std::array<Field, 3> force_;
  std::array<FloatField, 3> nodal_;  ///< impulses, then velocities of nodes
  std::vector<Work> work_;
  CellLaplacian all_fluids_;
  Multigrid multigrid_;
  FloatField summed_residual_, long_waves_;
};

}  // namespace zona::mpm
