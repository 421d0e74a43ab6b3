#include "studies/kinds/material_point/path.h"

#include <algorithm>

namespace zona::studies {

using mpm::SymmetricTensor;

mpm::FreeComponents free_components(const Configuration& study) {
  mpm::FreeComponents free{};
  for (const std::string& name : study.texts("path.free")) {
    const auto at = std::find(strain_components.begin(), strain_components.end(), name);
    free[at - strain_components.begin()] = true;
  }
  return free;
}

std::vector<SymmetricTensor> path_strains(const Configuration& study) {
  std::vector<std::vector<double>> lists;
  std::size_t segments = 0;
  for (const std::string name : strain_components) {
    lists.push_back(study.numbers("path." + name));
    segments = std::max(segments, lists.back().size());
  }
  const auto free = free_components(study);
  std::vector<SymmetricTensor> targets(segments);
  for (std::size_t s = 0; s < segments; ++s) {
    for (int c = 0; c < 6; ++c) {
      targets[s][c] = free[c] ? 0 : lists[c][std::min(s, lists[c].size() - 1)];
    }
  }
  return targets;
}

}  // namespace zona::studies
