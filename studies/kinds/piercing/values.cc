#include "studies/kinds/piercing/values.h"

#include <cmath>

namespace zona::studies {

double zona_edge_length(const Configuration& study) {
  constexpr double edge_of_icosahedron = 1.1071487177940904;  // atan(2), on the unit sphere
  const int level = static_cast<int>(study.integer("zona.level"));
  return std::ldexp(edge_of_icosahedron * study.quantity("zona.diameter") / 2, -level);
}

double pipette_point_density(const Configuration& study, double fluid_density) {
  if (!study.is_auto("pipette.point_density")) return study.quantity("pipette.point_density");
  const double outer = study.quantity("pipette.outer_diameter");
  const double inner = study.quantity("pipette.inner_diameter");
  const double bore_per_glass = inner * inner / (outer * outer - inner * inner);
  return study.quantity("pipette.density") + fluid_density * bore_per_glass;
}

double motion_amplitude(const Configuration& study) {
  if (!study.is_auto("motion.amplitude")) return study.quantity("motion.amplitude");
  return study.choice("motion.kind") == "triangle" ? 1.8e-6 : 13.5e-6;
}

double simulation_end(const Configuration& study) {
  if (!study.is_auto("time.end")) return study.quantity("time.end");
  const std::string& kind = study.choice("motion.kind");
  if (kind == "sine") return study.quantity("motion.period");
  if (kind == "triangle") return study.quantity("motion.duration");
  return study.quantity("motion.window_length");
}

}  // namespace zona::studies
