#pragma once

#include <optional>

#include "mpm/materials/fluid.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// A [[body]] of gas or liquid.
struct SceneFluid {
  std::optional<Formula> pressure;  ///< initial, of the place [Pa]; always given
  std::optional<double> gamma;      ///< of a gas [-]; empty: a liquid
  double grueneisen;                ///< of a liquid [-]
  double p_infinity;                ///< of a liquid [Pa]
  double viscosity;                 ///< [Pa s]
  mpm::EnergyIncrement energy_increment;
  double artificial_viscosity_quadratic;  ///< [-]
  double artificial_viscosity_linear;     ///< [-]

  /// Without density and pressure.
  mpm::FluidProperties properties() const;
};

/// Keys of a fluid in a section that is open, under the conditions of a gas, of a liquid, or of
/// either.
void declare_scene_fluid(Schema& schema, const std::string& section, const Condition& gas,
                         const Condition& liquid);

}  // namespace zona::studies
