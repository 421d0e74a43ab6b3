#include "studies/kinds/scene/grid_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/parameters/numerics_table.h"

namespace zona::studies {

namespace {

void check_cells(const Configuration& study, const Complain& complain) {
  const Eigen::Vector3d low = study.value(&SceneGrid::low), high = study.value(&SceneGrid::high);
  const Eigen::Vector3d cell = study.value(&SceneGrid::cell);
  const std::string high_key = study.key(&SceneGrid::high);
  const std::string cell_key = study.key(&SceneGrid::cell);
  double cells = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = high[axis] - low[axis];
    const double count = extent / cell[axis];
    if (!(extent > 0)) {
      complain(high_key, fmt::format("{} = {:g} m is not above {}, {:g} m", "xyz"[axis], high[axis],
                                     study.key(&SceneGrid::low), low[axis]));
      return;
    }
    if (std::abs(count - std::round(count)) > 1e-6 || count < 0.5) {
      complain(
          cell_key,
          fmt::format("the grid is {:g} m along {}, {:g} cells of {:g} m; needs a whole number, "
                      "e.g. cells of {:g} m",
                      extent, "xyz"[axis], count, cell[axis],
                      extent / std::max(1.0, std::round(count))));
      return;
    }
    cells *= count;
  }
  if (cells > 5e7) complain(cell_key, fmt::format("{:g} cells; at most 5e7 are allowed", cells));
}

}  // namespace

mpm::BackgroundGrid SceneGrid::grid() const {
  std::array<int, 3> cells;
  for (int axis = 0; axis < 3; ++axis) {
    cells[axis] = static_cast<int>(std::lround((high[axis] - low[axis]) / cell[axis]));
  }
  return {low, cell, cells, interpolation};
}

void declare_scene_grid(Schema& schema) {
  TableKeys<SceneGrid> keys(
      schema, "grid", "The background grid of box-shaped cells. Two dimensions: one cell thick.");
  keys.quantities("low", &SceneGrid::low, "m", {"0 m", "0 m", "0 m"})
      .exactly(3)
      .in("[-1e6, 1e6]")
      .doc("Lowest corner.");
  keys.quantities("high", &SceneGrid::high, "m", {})
      .without_default()
      .exactly(3)
      .in("[-1e6, 1e6]")
      .doc("Highest corner; a whole number of cells away.");
  keys.quantities("cell", &SceneGrid::cell, "m", {})
      .without_default()
      .exactly(3)
      .or_one_for_all()
      .in("(0, 1e6]")
      .doc("Edges of a cell along x, y and z.");
  keys.choice("interpolation", &SceneGrid::interpolation, interpolations()).doc(kInterpolationText);
  schema.check(check_cells);
}

}  // namespace zona::studies
