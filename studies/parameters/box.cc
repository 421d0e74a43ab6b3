#include "studies/parameters/box.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace zona::studies {

using Eigen::Vector3d;

void declare_box(Schema& schema, const std::string& section, const std::string& documentation,
                 const std::vector<Condition>& conditions) {
  const double far = std::numeric_limits<double>::infinity();
  const auto corner = [&](const char* name, double end, const std::string& sentences) {
    Parameter& parameter = schema.quantities(section + "." + name, "m", {"grid", "grid", "grid"})
                               .exactly(3)
                               .in("[-1e6, 1e6]")
                               .or_named({{"grid", end}})
                               .doc(sentences);
    parameter.conditions = conditions;
  };
  corner("low", -far, documentation + " Lower corner; \"grid\" reaches as far as the grid does.");
  corner("high", far, "Upper corner of that box.");
}

void check_box(const Table& table, const Complain& complain, bool may_be_flat) {
  if (!table.applies("low")) return;
  const auto low = table.quantities("low"), high = table.quantities("high");
  for (int axis = 0; axis < 3; ++axis) {
    if (low[axis] < high[axis] || (may_be_flat && low[axis] == high[axis])) continue;
    complain("high", fmt::format("{} = {:g} m is not above low, {:g} m", "xyz"[axis], high[axis],
                                 low[axis]));
  }
}

mpm::Box box_of(const Table& table, const mpm::BackgroundGrid& grid, const Vector3d& origin) {
  const auto corner = [&](const char* leaf) -> Vector3d {
    const std::vector<double> place = table.quantities(leaf);
    return origin + Vector3d(place[0], place[1], place[2]);
  };
  const Vector3d low = corner("low");
  const Vector3d high = corner("high");
  const auto finite = [](double a, double b) { return std::isfinite(a) ? a : b; };
  return {low.binaryExpr(grid.origin(), finite), high.binaryExpr(grid.upper_corner(), finite)};
}

}  // namespace zona::studies
