#pragma once

#include <cmath>

namespace zona::mpm {

/// Stiffened gas (5.1): P + (Gamma + 1) P_inf = Gamma rho I.
/// The ideal gas (4.31) is Gamma = gamma - 1, P_inf = 0.
struct StiffenedGas {
  double grueneisen;  ///< Gamma [-]
  double p_infinity;  ///< P_inf [Pa]

  /// Ideal gas (4.31) with the ratio gamma of heat capacities [-].
  static constexpr StiffenedGas ideal_gas(double heat_capacity_ratio) {
    return {heat_capacity_ratio - 1, 0};
  }
  /// Pressure [Pa] at a density [kg/m^3] and a specific internal energy [J/kg].
  double pressure(double density, double energy) const {
    return grueneisen * density * energy - (grueneisen + 1) * p_infinity;
  }
  /// Specific internal energy [J/kg] at a pressure [Pa] and density [kg/m^3].
  double internal_energy(double pressure, double density) const {
    return (pressure + (grueneisen + 1) * p_infinity) / (grueneisen * density);
  }
  /// Isentropic speed of sound [m/s]: sqrt((Gamma + 1)(P + P_inf) / rho).
  double sound_speed(double pressure, double density) const {
    return std::sqrt((grueneisen + 1) * (pressure + p_infinity) / density);
  }
};

}  // namespace zona::mpm
