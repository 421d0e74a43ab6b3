#pragma once

#include <vector>

#include "mpm/conditions/boundary.h"

namespace zona::mpm {

/// Local non-viscous damping for problems with a static solution: reduces each component of a
/// node's force by a fraction of its magnitude, against the velocity. Balanced forces are not
/// damped, so static solutions do not change.
///
/// Held components and nodes touched by prescribed bodies are not damped: the force there is a
/// reaction, not an imbalance.
class LocalDamping {
 public:
  /// Throws ModelError unless `fraction` lies in [0, 1). `held_nodes` has the nodes of each entry
  /// of `held`.
  LocalDamping(double fraction, const BackgroundGrid& grid, const FaceConditions& faces,
               const std::vector<HeldNodes>& held, const std::vector<std::vector<int>>& held_nodes);

  /// Reduces acceleration and velocity at the end of a step of dt [s], after the momentum is
  /// advanced and the held nodes are set.
  void apply(BackgroundGrid& grid, const std::vector<Body>& bodies, double dt, int threads) const;

 private:
  double fraction_;
  std::vector<std::array<bool, 3>> held_;  ///< held components of each node
};

}  // namespace zona::mpm
