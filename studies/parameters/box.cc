#include "studies/parameters/box.h"

#include <fmt/format.h>

#include <cmath>

namespace zona::studies {

mpm::Box BoxKeys::in(const mpm::BackgroundGrid& grid, const Eigen::Vector3d& origin) const {
  const auto finite = [](double a, double b) { return std::isfinite(a) ? a : b; };
  return {(origin + low).binaryExpr(grid.origin(), finite),
          (origin + high).binaryExpr(grid.upper_corner(), finite)};
}

void check_box(const BoxKeys& box, bool may_be_flat, const std::string& high_key,
               const Complain& complain) {
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis], high = box.high[axis];
    if (low < high || (may_be_flat && low == high)) continue;
    complain(high_key, fmt::format("{} = {:g} m is not above low, {:g} m", "xyz"[axis], high, low));
  }
}

}  // namespace zona::studies
