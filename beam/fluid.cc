#include "beam/fluid.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace zona::beam {

const std::vector<Fluid>& named_fluids() {
  static const std::vector<Fluid> fluids = {
      {"none", 0, "air, whose mass is left out"},
      {"light_oil", 840, "light mineral oil, Sigma's, as quoted by studies of embryo culture"},
      {"water", 1000, "Table 5.7"},
      {"PVP", 1018, "10 % w/v in water at 25 C, estimated from 0.797 mL/g of the polymer"},
      {"perfluorooctane", 1766, "perfluoro-n-octane, Aldrich's catalogue, as quoted"},
      {"fluorinert", 1780, "Table 5.7"},
      {"FC-77", 1780, "3M's product information, as quoted"},
      {"FC-40", 1855, "3M's product information, 25 C, as quoted"},
      {"FC-70", 1940, "3M's product information, 25 C, as quoted"},
      {"galinstan", 6440, "at 20 C, as quoted; it wets glass"},
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
