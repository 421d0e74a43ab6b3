#include "beam/fluid.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace zona::beam {

const std::vector<Fluid>& named_fluids() {
  static const std::vector<Fluid> fluids = {
      {"none", 0, "air, of which the mass is left out"},
      {"light_oil", 840, "light mineral oil, 0.84 g/mL at 25 C (makers' catalogues)"},
      {"water", 1000, "Table 5.7"},
      {"PVP", 1020, "10 % of polyvinylpyrrolidone in water, 1.02 g/mL (estimated from its mass)"},
      {"perfluorooctane", 1766, "perfluoro-n-octane, 1.766 g/mL at 25 C (makers' catalogues)"},
      {"fluorinert", 1780, "Table 5.7"},
      {"FC-77", 1780, "3M product information, 25 C"},
      {"FC-40", 1855, "3M product information, 25 C"},
      {"FC-70", 1940, "3M product information, 25 C"},
      {"mercury", 13600, "Table 5.7"}};
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
