#pragma once

#include "mpm/materials/fluid.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// A stiffened-gas fluid (4.28)-(4.45).
struct FluidKeys {
  double density;     ///< [kg/m^3]
  double grueneisen;  ///< Gamma [-]
  double p_infinity;  ///< [Pa]
  double viscosity;   ///< [Pa s]
  int points_per_cell;
  double artificial_viscosity_quadratic;  ///< c_0 [-]
  double artificial_viscosity_linear;     ///< c_1 [-]

  mpm::FluidProperties properties(mpm::EnergyIncrement energy_increment) const;
};

/// The fluid in the zona, and the one around it.
struct Cytoplasm : FluidKeys {};
struct Medium : FluidKeys {};

/// The sections [cytoplasm] and [medium].
void declare_fluids(Schema& schema);

}  // namespace zona::studies
