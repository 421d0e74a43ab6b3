#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "studies/references/require.h"

namespace zona::studies::references {

/// Displacement at a time [s] within samples at equal intervals from t = 0, linear between them.
/// Throws ModelError for a time outside.
template <class Sample>
double displacement_at(const std::vector<Sample>& samples, double time) {
  require(samples.size() >= 2, "the history has no samples");
  const double interval = samples[1].time - samples[0].time;
  require(time >= 0 && time <= samples.back().time * (1 + 1e-9),
          "the history ends at " + std::to_string(samples.back().time) + " s, before " +
              std::to_string(time) + " s");
  const auto i = std::min(static_cast<std::size_t>(time / interval), samples.size() - 2);
  const double share = (time - samples[i].time) / interval;
  return (1 - share) * samples[i].displacement + share * samples[i + 1].displacement;
}

}  // namespace zona::studies::references
