#include "mpm/results/cell_averages.h"

#include <limits>

#include "mpm/points/errors.h"

namespace zona::mpm {

namespace {

/// Sums over the points of one cell.
struct CellSums {
  double mass = 0;
  double volume = 0;
  double volume_pressure = 0;
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
};

CellSums sums_of(const Body& body, const Fluid& fluid, const int* first, const int* last) {
  CellSums sums;
  for (const int* point = first; point != last; ++point) {
    const int p = *point;
    const double volume = body.points.mass[p] / fluid.density[p];
    const double pressure = -(fluid.stress[0][p] + fluid.stress[1][p] + fluid.stress[2][p]) / 3;
    sums.mass += body.points.mass[p];
    sums.volume += volume;
    sums.volume_pressure += volume * pressure;
    sums.momentum += body.points.mass[p] * body.points.velocity_of(p);
  }
  return sums;
}

/// Index of a brick's cell among all cells, x fastest.
std::size_t cell_number(const BackgroundGrid& grid, const Brick& brick, int cell) {
  const int edge = Brick::edge;
  const std::array<int, 3> offset{cell % edge, cell / edge % edge, cell / (edge * edge)};
  std::size_t number = 0;
  for (int axis = 2; axis >= 0; --axis) {
    number = number * grid.cells()[axis] + brick.first_cell[axis] + offset[axis];
  }
  return number;
}

std::array<std::vector<double>, 3> boundaries_of(const BackgroundGrid& grid) {
  std::array<std::vector<double>, 3> boundaries;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i <= grid.cells()[axis]; ++i) {
      boundaries[axis].push_back(grid.origin()[axis] + i * grid.cell_size()[axis]);
    }
  }
  return boundaries;
}

}  // namespace

CellFields cell_averages(const Body& body, const BackgroundGrid& grid, const std::string& name) {
  const auto* fluid = std::get_if<Fluid>(&body.material);
  if (!fluid) throw ModelError("body '" + body.name + "' is not a fluid and has no pressure");
  const std::size_t count =
      static_cast<std::size_t>(grid.cells()[0]) * grid.cells()[1] * grid.cells()[2];
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> pressure(count, nan), density(count, nan), velocity(3 * count, nan);
  std::vector<double> points(count, 0);
  for (int b = 0; b < body.cells.brick_count(); ++b) {
    const BrickPoints& brick = body.cells.brick(b);
    for (int c = 0; c < Brick::cell_count; ++c) {
      if (brick.begin[c] == brick.begin[c + 1]) continue;
      const int* all = brick.points.data();
      const CellSums sums = sums_of(body, *fluid, all + brick.begin[c], all + brick.begin[c + 1]);
      const std::size_t cell = cell_number(grid, grid.bricks()[b], c);
      points[cell] = brick.begin[c + 1] - brick.begin[c];
      pressure[cell] = sums.volume_pressure / sums.volume;
      density[cell] = sums.mass / sums.volume;
      for (int i = 0; i < 3; ++i) velocity[3 * cell + i] = sums.momentum[i] / sums.mass;
    }
  }
  return {name,
          boundaries_of(grid),
          {{"pressure", std::move(pressure)},
           {"density", std::move(density)},
           {"velocity", std::move(velocity)},
           {"points", std::move(points)}}};
}

}  // namespace zona::mpm
