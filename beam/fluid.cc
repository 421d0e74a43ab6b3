#include "beam/fluid.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace zona::beam {

const std::vector<Fluid>& named_fluids() {
  static const std::vector<Fluid> fluids = {
      {"none", 0}, {"water", 1000}, {"fluorinert", 1780}, {"mercury", 13600}};
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
