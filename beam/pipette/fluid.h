#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace zona::beam {

/// What fills the bore of the pipette. Across itself the beam feels its density only, along itself
/// its viscosity, too.
struct Fluid {
  std::string name;      ///< what studies call it
  double density = 0;    ///< [kg/m^3]
  double viscosity = 0;  ///< [Pa s]
  std::string source;    ///< where both come from
};

/// The fills of Table 5.7, the empty pipette and fluids that might take the place of mercury, in
/// the order of increasing density.
const std::vector<Fluid>& named_fluids();

/// The named fluid; throws std::invalid_argument that lists the known names for any other.
const Fluid& named_fluid(std::string_view name);

}  // namespace zona::beam
