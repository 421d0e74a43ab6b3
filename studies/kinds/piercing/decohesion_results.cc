#include "studies/kinds/piercing/decohesion_results.h"

namespace zona::studies {

nlohmann::json decohesion_results(const mpm::MembraneState<mpm::VonMises>& state) {
  const auto& surfaces = state.surfaces;
  int plastic = 0;
  int opening = 0;
  int failed = 0;
  double dissipated = 0;
  double resolved = 0;
  for (std::size_t point = 0; point < surfaces.opened.size(); ++point) {
    const int p = static_cast<int>(point);
    plastic += state.internal[p] > 0;
    if (!surfaces.surface(p).present()) continue;
    ++(surfaces.failed(p) ? failed : opening);
    if (!surfaces.failed(p)) continue;
    dissipated += surfaces.dissipated[p];
    resolved += surfaces.surface(p).energy(*state.law.decohesion);
  }
  nlohmann::json r;
  r["plastic_points"] = plastic;
  r["opening_points"] = opening;
  r["dissipated_per_area"] = failed > 0 ? nlohmann::json(dissipated / failed) : nlohmann::json();
  r["resolved_energy_per_area"] = failed > 0 ? nlohmann::json(resolved / failed) : nlohmann::json();
  return r;
}

}  // namespace zona::studies
