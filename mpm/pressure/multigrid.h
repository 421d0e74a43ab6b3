#pragma once

#include <vector>

#include "mpm/pressure/lattice_loop.h"

namespace zona::mpm {

/// A discrete Laplacian on the cells of a lattice.
struct CellLaplacian {
  /// All zero.
  explicit CellLaplacian(const CellLattice& lattice);

  CellLattice lattice;                 ///< places of the cells
  std::array<FloatField, 3> coupling;  ///< of a cell to the next along each axis
  FloatField excess;                   ///< of the diagonal over the sum of couplings
};

/// Correction of long waves, which conjugate gradients are slow to find: one V-cycle of geometric
/// multigrid for a Laplacian on the lattices of 2, 4, 8, ... cells, with trilinear transfers and
/// Gauss-Seidel sweeps over cells of even and of odd index sum. Symmetric; of single precision,
/// since it need not be exact. All calls by all threads of a parallel region.
class Multigrid {
 public:
  /// Levels above the lattice of a grid.
  explicit Multigrid(const CellLattice& lattice);

  /// Takes over the Laplacian of the finest lattice.
  void set(const CellLaplacian& finest);
  /// Adds the correction for the residual r to z; both lie on the finest lattice.
  void add_correction(const FloatField& r, FloatField& z);

 private:
  struct Level {
    explicit Level(const CellLattice& lattice);

    CellLaplacian laplacian;
    std::array<FloatField, 2> inverse_diagonal;  ///< of cells of even and of odd index sum
    FloatField unknown, right, residual;
  };
  void set_levels(std::size_t n, const CellLaplacian& fine);
  void cycle(std::size_t n);
  void correct(std::size_t n, const CellLattice& fine, const FloatField& r, FloatField& z);
  static void set_diagonal(Level& level);
  static void coarsen(const CellLaplacian& fine, CellLaplacian& coarse);
  static void smooth(Level& level, int colour, bool from_zero = false);
  static void set_residual(Level& level);
  static void restrict_to(Level& coarse, const CellLattice& lattice, const FloatField& fine);
  static void add_prolonged(const Level& coarse, const CellLattice& lattice, FloatField& fine);

  CellLattice finest_;
  std::vector<Level> levels_;  ///< without the finest
};

}  // namespace zona::mpm
