#include "mpm/conditions/damping.h"

#include <fmt/format.h>

#include "mpm/points/errors.h"

namespace zona::mpm {

LocalDamping::LocalDamping(double fraction, const BackgroundGrid& grid, const FaceConditions& faces,
                           const std::vector<HeldNodes>& held,
                           const std::vector<std::vector<int>>& held_nodes)
    : fraction_(fraction) {
  if (!(fraction >= 0 && fraction < 1)) {
    throw ModelError(fmt::format("the damping must lie in [0, 1), got {}", fraction));
  }
  if (fraction == 0) return;
  held_.assign(grid.node_count(), {});
  for_each_held(grid, faces, [this](int node, int axis) { held_[node][axis] = true; });
  for (std::size_t h = 0; h < held.size(); ++h) {
    for (int node : held_nodes[h]) {
      for (int axis = 0; axis < 3; ++axis) held_[node][axis] |= held[h].axes[axis];
    }
  }
}

void LocalDamping::apply(BackgroundGrid& grid, const std::vector<Body>& bodies, double dt,
                         int threads) const {
  if (fraction_ == 0) return;
  auto held = held_;
  for (const auto& body : bodies) {
    if (!body.prescribed()) continue;
    for (int node : touched_nodes(grid, body.cells)) held[node] = {true, true, true};
  }
  const auto nodes = static_cast<long>(grid.node_count());
#pragma omp parallel for num_threads(threads) schedule(static)
  for (long n = 0; n < nodes; ++n) {
    Lanes& state = grid.state[n];
    for (int axis = 0; axis < 3; ++axis) {
      const double acceleration = state[4 + axis];
      const double before = state[1 + axis] - dt * acceleration;
      if (held[n][axis] || before == 0) continue;
      const double less = std::copysign(fraction_ * std::abs(acceleration), before);
      state[4 + axis] -= less;
      state[1 + axis] -= dt * less;
    }
  }
}

}  // namespace zona::mpm
