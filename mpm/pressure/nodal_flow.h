#pragma once

#include <vector>

#include "mpm/bodies/body.h"
#include "mpm/conditions/boundary.h"
#include "mpm/pressure/lattice_loop.h"

namespace zona::mpm {

/// Motion of the nodes in a step without the pressure, and how pressures change it, per place of a
/// CellLattice.
///
/// A node that bodies with prescribed motion share moves by forces only as far as the mass m_f of
/// the other points lets it: v changes by dt f m_f / m^2, because at the end of the step the
/// prescribed points have their own velocity again. The other points' acceleration is f / m. Small
/// steps of an explicit pressure do the same, one after the other.
class NodalFlow {
 public:
  /// All zero.
  explicit NodalFlow(const CellLattice& lattice);

  std::array<Field, 3> velocity;       ///< at the end of the step [m/s]
  std::array<FloatField, 3> mobility;  ///< velocity per impulse, zero where held [1/kg]
  std::array<Field, 3> inverse_mass;   ///< acceleration of the points per force [1/kg]

  /// Takes over the nodes after the momentum is advanced by dt [s]. Absorbing faces act with the
  /// normal velocity at the end of the step. Corrects velocity and acceleration in the grid.
  void take(BackgroundGrid& grid, const FaceConditions& faces, const std::vector<Body>& bodies,
            double time, double dt, int threads);
  /// Prescribes a component of a node's velocity [m/s] at the end of the step.
  void hold(const BackgroundGrid& grid, int node, int axis, double value);
  /// Adds the effect of forces [N] to velocity and acceleration in the grid.
  void push(BackgroundGrid& grid, const std::array<Field, 3>& force, double dt, int threads) const;

 private:
  void add_prescribed(const BackgroundGrid& grid, const std::vector<Body>& bodies, double time);
  void absorb(BackgroundGrid& grid, const FaceConditions& faces, double dt);

  CellLattice lattice_;
  /// Per node: mass of bodies with prescribed motion [kg], and the momentum that it gains [N s].
  std::vector<HalfLanes, AlignedAllocator<HalfLanes>> prescribed_;
  std::vector<int> touched_;  ///< nodes with such mass, with repetitions
};

}  // namespace zona::mpm
