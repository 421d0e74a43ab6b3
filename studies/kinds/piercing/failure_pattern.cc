#include "studies/kinds/piercing/failure_pattern.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace zona::studies {

FailurePattern failure_pattern(const mpm::Membrane& zona,
                               const std::vector<Eigen::Vector3d>& reference,
                               const mpm::Tube& tip) {
  FailurePattern pattern;
  double area = 0, outside = 0;
  for (std::size_t p = 0; p < reference.size(); ++p) {
    if (!zona.failed(static_cast<int>(p))) continue;
    const double part = zona.reference_area[p];
    const double y = reference[p].y() - tip.end.y();
    const double z = reference[p].z() - tip.end.z();
    const double distance = std::hypot(y, z);
    pattern.y_low = area > 0 ? std::min(pattern.y_low, y) : y;
    pattern.y_high = area > 0 ? std::max(pattern.y_high, y) : y;
    pattern.z_low = area > 0 ? std::min(pattern.z_low, z) : z;
    pattern.z_high = area > 0 ? std::max(pattern.z_high, z) : z;
    area += part;
    pattern.mean_distance += part * distance;
    if (distance <= tip.outer_radius) {
      pattern.share_under_tip += part;
      continue;
    }
    outside += part;
    const double angle = std::atan2(std::abs(z), std::abs(y)) * 180 / M_PI;
    (angle < 30   ? pattern.share_along
     : angle < 60 ? pattern.share_diagonal
                  : pattern.share_across) += part;
  }
  if (area > 0) {
    pattern.mean_distance /= area;
    pattern.share_under_tip /= area;
  }
  if (outside > 0) {
    for (double* share : {&pattern.share_along, &pattern.share_diagonal, &pattern.share_across}) {
      *share /= outside;
    }
  }
  return pattern;
}

nlohmann::json to_json(const FailurePattern& p) {
  return {{"y_low", p.y_low},
          {"y_high", p.y_high},
          {"z_low", p.z_low},
          {"z_high", p.z_high},
          {"mean_distance", p.mean_distance},
          {"share_under_tip", p.share_under_tip},
          {"share_along", p.share_along},
          {"share_diagonal", p.share_diagonal},
          {"share_across", p.share_across}};
}

}  // namespace zona::studies
