#include "beam/pipette/fluid.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace zona::beam {

const std::vector<Fluid>& named_fluids() {
  static const std::vector<Fluid> fluids = {
      {"none", 0, 1.8e-5, "air, whose mass is left out"},
      {"light_oil", 840, 2.5e-2,
       "light mineral oil, Sigma's, as quoted by studies of embryo culture; typical viscosity, "
       "1.5e-2 to 3.5e-2"},
      {"water", 1000, 8.9e-4, "Table 5.7; viscosity by IAPWS, 25 C"},
      {"PVP", 1018, 0.5,
       "10 % w/v in water at 25 C, estimated from 0.797 mL/g of the polymer; typical viscosity of "
       "povidone K-90, within a factor of three, less when sheared fast"},
      {"perfluorooctane", 1766, 1.4e-3,
       "perfluoro-n-octane, Aldrich's catalogue, as quoted; typical viscosity"},
      {"fluorinert", 1780, 1.3e-3, "Table 5.7; viscosity of FC-77, whose density it has"},
      {"FC-77", 1780, 1.3e-3, "3M's product information, as quoted; typical viscosity"},
      {"FC-40", 1855, 3.4e-3,
       "3M's product information, 25 C, as quoted; typical viscosity, 3.4e-3 to 4.1e-3"},
      {"FC-70", 1940, 2.4e-2, "3M's product information, 25 C, as quoted; typical viscosity"},
      {"galinstan", 6440, 2.4e-3, "at 20 C, as quoted; it wets glass"},
      {"mercury", 13600, 1.526e-3, "Table 5.7; viscosity by Viswanath and Natarajan, 25 C"}};
  return fluids;
}

const Fluid& named_fluid(std::string_view name) {
  const auto& fluids = named_fluids();
  const auto found = std::find_if(fluids.begin(), fluids.end(),
                                  [&](const Fluid& fluid) { return fluid.name == name; });
  if (found != fluids.end()) return *found;
  std::string known;
  for (const Fluid& fluid : fluids) known += (known.empty() ? "" : ", ") + fluid.name;
  throw std::invalid_argument(
      fmt::format("fluid: '{}' is not one of {}; give one of these or a density", name, known));
}

}  // namespace zona::beam
