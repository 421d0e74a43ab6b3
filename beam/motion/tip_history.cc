#include "beam/motion/tip_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam/algebra/require.h"

namespace zona::beam {

std::size_t index_of_peak(const std::vector<double>& values) {
  const auto peak = std::max_element(values.begin(), values.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
  return peak - values.begin();
}

double amplitude_ratio(const TipHistory& history, double support_peak) {
  require(
      std::isfinite(support_peak) && support_peak != 0,
      fmt::format("amplitude ratio: the peak support displacement is {} m, but it must be finite "
                  "and not 0; move the support",
                  support_peak));
  require(!history.displacement.empty(), "amplitude ratio: the history has no samples");
  const double peak = history.displacement[index_of_peak(history.displacement)];
  return std::abs(peak / support_peak);
}

}  // namespace zona::beam
