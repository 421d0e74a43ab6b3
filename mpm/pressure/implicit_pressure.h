#pragma once

#include <string>
#include <vector>

#include "mpm/bodies/body.h"
#include "mpm/points/state_visitor.h"
#include "mpm/pressure/nodal_flow.h"
#include "mpm/pressure/pressure_system.h"

namespace zona::mpm {

/// Implicit pressure of the fluids: the step does not wait for sound. At the end of a step
///
///     m_i v_i = m_i v*_i + dt sum_c G_ci q_c           momentum of node i; v* without the pressure
///     V_c x_c / dt = sum_i G_ci . v_i                  volumetric strain x of the fluid in cell c
///     q_c = p_c + theta (P_c(x_c) - p_c)               pressure that acts; p before the step
///
/// with the equation of state P of the cell's points (CellLaw). This is the idea of the Implicit
/// Continuous-fluid Eulerian method (Harlow and Amsden 1971) and of the projected material point
/// method (Zhang et al. 2017), with the compressibility kept. theta = 1 - 1 / (4 C^2) with the
/// Courant number C of the cell, a dt / h for a full one, more where its nodes are light: large
/// steps damp sound (backward Euler). Below C = 1/2 theta is next to nothing: the step is the
/// explicit one, which keeps the energy of sound, at second order. Any step is stable, since theta
/// is above 1/2 - 1/(6 C^2).
///
/// The law is linearised again until the mass balance holds to `balance_tolerance`, a volumetric
/// strain. All points of a cell then get its strain rate.
class ImplicitPressure {
 public:
  /// Of x, about 1 Pa in water.
  static constexpr double balance_tolerance = 1e-9;

  /// For the fluids among the bodies, to which it gives FluidCells, and steps of dt [s].
  /// `tolerance` is the greatest norm of the residual of the mass balance over that of the
  /// expansion that the pressure prevents. Throws ModelError for a tolerance outside of
  /// [1e-10, 0.1] and for quadratic shape functions.
  ImplicitPressure(const BackgroundGrid& grid, std::vector<Body>& bodies, double tolerance,
                   double dt, int threads);

  NodalFlow flow;  ///< to be set before `solve`

  /// Solves for the pressures of the cells whose sums the bodies hold, and sets the rates of
  /// volumetric strain there. Returns the forces on the nodes [N]. Throws StepError, with the
  /// number of the step, if a solution does not converge.
  const std::array<Field, 3>& solve(std::vector<Body>& bodies, long step);

  /// Mean number of iterations of conjugate gradients for a linear system, so far.
  double mean_iterations() const {
    return systems_ > 0 ? static_cast<double>(iterations_) / static_cast<double>(systems_) : 0;
  }
  /// Visits the counts of the work so far; a step needs nothing of the last one.
  void visit_state(StateVisitor& visitor) {
    visitor.visit("pressure/systems", systems_);
    visitor.visit("pressure/iterations", iterations_);
  }

 private:
  /// One fluid; per place of the lattice.
  struct Fluid {
    std::size_t body;
    FloatField diagonal;  ///< of G M^-1 G^T [m^4/kg]
    Field implicitness;   ///< theta [-]
    Field strain;         ///< x, at which the law is linearised [-]
    Field acting;         ///< pressure that acts at this strain [Pa]
    Field softness;       ///< strain per pressure that acts [1/Pa]
    Field expansion;      ///< by the flow without the pressure [m^3/s]
  };
  void start(Body& body, std::size_t f, const Chunk& chunk);
  void set_implicitness(const Body& body, std::size_t f, const Chunk& chunk);
  std::array<double, 2> linearise(const Body& body, std::size_t f, const Chunk& chunk);
  double accept(Body& body, std::size_t f, const Chunk& chunk);

  [[noreturn]] void fail(const std::vector<Body>& bodies, long step, const std::string& what) const;

  double tolerance_;
  double dt_;
  double length_;
  std::array<double, 3> inverse_cell_;
  int threads_;
  CellLattice lattice_;
  LatticeLoop loop_;
  std::vector<Fluid> fluids_;
  PressureSystem system_;
  std::int64_t systems_ = 0;
  std::int64_t iterations_ = 0;
};

}  // namespace zona::mpm
