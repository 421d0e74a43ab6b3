#include "beam/motion/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam/algebra/require.h"

namespace zona::beam {

namespace {

constexpr double max_samples = 1e8;

}  // namespace

int sample_count(const Sampling& sampling) {
  require(is_positive(sampling.step) && is_positive(sampling.end),
          fmt::format("sampling: a step of {} s up to {} s, but both must be greater than 0",
                      sampling.step, sampling.end));
  const double intervals = std::ceil(sampling.end / sampling.step - 1e-6);
  require(intervals < max_samples,
          fmt::format("sampling: a step of {} s up to {} s makes {} samples, but at most {} are "
                      "allowed; use a longer step",
                      sampling.step, sampling.end, intervals, max_samples));
  return std::max(1, static_cast<int>(intervals)) + 1;
}

}  // namespace zona::beam
