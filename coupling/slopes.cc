#include "coupling/slopes.h"

#include <stdexcept>

namespace zona::coupling {

std::vector<double> second_order_slopes(const std::vector<double>& time,
                                        const std::vector<double>& values) {
  const std::size_t samples = time.size();
  if (samples < 3 || values.size() != samples)
    throw std::invalid_argument(
        "second_order_slopes: needs three or more samples and as many times");
  const auto secant = [&](std::size_t i) {
    return (values[i + 1] - values[i]) / (time[i + 1] - time[i]);
  };
  std::vector<double> slopes(samples);
  for (std::size_t i = 1; i + 1 < samples; ++i) {
    const double before = time[i] - time[i - 1];
    const double after = time[i + 1] - time[i];
    slopes[i] = (after * secant(i - 1) + before * secant(i)) / (before + after);
  }
  // The slopes of a parabola at the ends of an interval have its secant as their mean.
  slopes.front() = 2 * secant(0) - slopes[1];
  slopes.back() = 2 * secant(samples - 2) - slopes[samples - 2];
  return slopes;
}

}  // namespace zona::coupling
