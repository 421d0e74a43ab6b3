#include "studies/references/profile_errors.h"

#include <algorithm>
#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

ProfileErrors profile_errors(const std::vector<Sample>& samples,
                             const std::function<double(double)>& exact) {
  require(!samples.empty(), "a profile without samples has no error");
  ProfileErrors errors;
  double length = 0;
  for (const Sample& s : samples) {
    require_positive(s.length, "length of every sample");
    const double e = std::abs(s.value - exact(s.x));
    errors.l1 += s.length * e;
    errors.l2 += s.length * e * e;
    errors.largest = std::max(errors.largest, e);
    length += s.length;
  }
  errors.l1 /= length;
  errors.l2 = std::sqrt(errors.l2 / length);
  return errors;
}

double observed_order(const std::vector<double>& h, const std::vector<double>& error) {
  require(h.size() == error.size() && h.size() >= 2,
          "an order needs two or more errors and as many spacings, not " +
              std::to_string(error.size()) + " and " + std::to_string(h.size()));
  const double n = static_cast<double>(h.size());
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    require_positive(h[i], "spacing");
    require_positive(error[i], "error to have an order");
    mean_x += std::log(h[i]) / n;
    mean_y += std::log(error[i]) / n;
  }
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double x = std::log(h[i]) - mean_x;
    xx += x * x;
    xy += x * (std::log(error[i]) - mean_y);
  }
  require(xx > 0, "an order needs errors at different spacings");
  return xy / xx;
}

double extrapolated(double h_coarse, double coarse, double h_fine, double fine, double order) {
  require(h_coarse > h_fine && h_fine > 0, "extrapolation needs a coarse and a finer spacing");
  return fine + (fine - coarse) / (std::pow(h_coarse / h_fine, order) - 1);
}

}  // namespace zona::studies::references
