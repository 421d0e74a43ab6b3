#pragma once

#include <vector>

#include "mpm/conditions/boundary.h"

namespace zona::mpm {

/// Local non-viscous damping for problems that are to come to rest: each component of a node's
/// force is reduced by a fraction of its magnitude, against the velocity. Where forces balance
/// there is nothing to damp, so static solutions stay what they are.
///
/// Held components and nodes that prescribed bodies touch are left alone: the force there is a
/// reaction, not one out of balance.
class LocalDamping {
 public:
  /// `fraction` in [0, 1), or ModelError; `held_nodes` are those of each of `held`.
  LocalDamping(double fraction, const BackgroundGrid& grid, const FaceConditions& faces,
               const std::vector<HeldNodes>& held, const std::vector<std::vector<int>>& held_nodes);

  /// Reduces acceleration and velocity at the end of a step of dt [s], after the momentum is
  /// advanced and what is held is held.
  void apply(BackgroundGrid& grid, const std::vector<Body>& bodies, double dt, int threads) const;

 private:
  double fraction_;
  std::vector<std::array<bool, 3>> held_;  ///< components of each node
};

}  // namespace zona::mpm
