#pragma once

#include "mpm/materials/equation_of_state.h"

namespace zona::studies::references {

/// A uniform fluid, (stiffened) gas of (4.31) or (5.1).
struct FluidState {
  double density;          ///< [kg/m^3]
  double velocity;         ///< [m/s]
  double pressure;         ///< [Pa]
  double internal_energy;  ///< specific [J/kg]; input states may leave it out
};

/// A wave that runs into one side of the initial discontinuity, between the speeds of its head (the
/// edge towards the undisturbed fluid) and its tail. A shock has head == tail.
struct SideWave {
  bool shock;
  double head;  ///< [m/s]
  double tail;  ///< [m/s]
};

/// Exact solution of the Riemann problem: at t = 0 a fluid at rest or moving uniformly fills x < 0,
/// another one x > 0. What follows depends on x/t alone: left wave, contact, right wave.
struct RiemannSolution {
  mpm::StiffenedGas left_gas, right_gas;
  FluidState left, right;            ///< undisturbed
  FluidState left_star, right_star;  ///< on both sides of the contact: equal pressure and velocity
  SideWave left_wave, right_wave;

  /// State at x/t [m/s].
  FluidState at(double speed) const;
};

/// Solves for the pressure p* at which both sides have one velocity (Toro, Riemann Solvers and
/// Numerical Methods for Fluid Dynamics, 3rd ed., chapter 4), by bisection to the last bit. With
/// P = p + P_inf a stiffened gas obeys the ideal gas' formulas in P: across a shock
///   u* - u = +-(p* - p) sqrt(2/((g + 1) rho) / (P* + (g - 1)/(g + 1) P)),
/// and across a rarefaction u* - u = +-2a/(g - 1) ((P* / P)^((g - 1)/2g) - 1), g = Gamma + 1. The
/// sides may be different fluids. Throws ModelError for a density or P that is not positive, and
/// when the fluids part and leave a vacuum.
RiemannSolution solve_riemann(const mpm::StiffenedGas& left_gas, FluidState left,
                              const mpm::StiffenedGas& right_gas, FluidState right);

/// Both sides the same ideal gas.
RiemannSolution solve_shock_tube(double heat_capacity_ratio, FluidState left, FluidState right);

/// The tube of 4.4.1: air, 1 kg/m^3 and 1 Pa against 0.125 kg/m^3 and 0.001 Pa, at rest.
RiemannSolution shock_tube_of_the_source();
/// Sod's tube: 1 kg/m^3 and 1 Pa against 0.125 kg/m^3 and 0.1 Pa, at rest.
RiemannSolution sods_tube();

}  // namespace zona::studies::references
