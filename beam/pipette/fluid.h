#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace zona::beam {

/// A fluid in the bore of the pipette. Its density affects motion across the pipette; density and
/// viscosity affect motion along it.
struct Fluid {
  std::string name;      ///< name in studies
  double density = 0;    ///< [kg/m^3]
  double viscosity = 0;  ///< [Pa s]
  std::string source;    ///< reference of both values
};

/// The empty pipette, the fills of Table 5.7 and possible replacements of mercury, by increasing
/// density.
const std::vector<Fluid>& named_fluids();

/// The fluid with this name. Throws std::invalid_argument with the known names for any other.
const Fluid& named_fluid(std::string_view name);

}  // namespace zona::beam
