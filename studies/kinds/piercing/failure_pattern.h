#pragma once

#include <nlohmann/json_fwd.hpp>

#include "mpm/bodies/body.h"
#include "mpm/bodies/lattice.h"

namespace zona::studies {

/// Places of the failed points on the undeformed zona, seen along the pipette from the middle of
/// the contact: y along a lateral vibration, z across it. All zero while nothing has failed.
struct FailurePattern {
  double y_low = 0, y_high = 0;  ///< extent along the lateral vibration [m]
  double z_low = 0, z_high = 0;  ///< extent across it [m]
  double mean_distance = 0;      ///< of the failed area from the middle of the contact [m]
  double share_under_tip = 0;    ///< of the failed area, within the tip's outer radius [-]
  /// Shares of the failed area outside the tip's radius by direction: within 30 degrees of the
  /// vibration, within 30 degrees of the diagonals between, and across. A uniform ring has 1/3
  /// each.
  double share_along = 0, share_diagonal = 0, share_across = 0;
};

/// `reference` are the undeformed positions of the zona's points.
FailurePattern failure_pattern(const mpm::Membrane& zona,
                               const std::vector<Eigen::Vector3d>& reference, const mpm::Tube& tip);

nlohmann::json to_json(const FailurePattern& pattern);

}  // namespace zona::studies
