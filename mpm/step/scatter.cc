#include "mpm/step/scatter.h"

#include "mpm/grid/shape_functions.h"
#include "mpm/step/stages.h"

namespace zona::mpm {

namespace {

template <class Shape, Volumetric kind, class Material>
void scatter_cells(const Material& material, const Body& body, int b, BackgroundGrid& grid) {
  for_each_cell_or_batch(
      grid, b, body.cells.brick(b), kind == Volumetric::averaged ? 0 : Shape::few_points,
      [&](const Cell& cell, const int* begin, const int* end, int) {
        scatter_cell<Shape, kind>(material, body.points, cell, begin, end, grid);
      },
      [&](const Batch& batch) { scatter_batch(material, body.points, batch, grid); });
}

template <class Shape>
void scatter_fluid_cells(const Fluid& fluid, Body& body, int b, BackgroundGrid& grid) {
  for_each_cell(grid, b, body.cells.brick(b),
                [&](const Cell& cell, const int* begin, const int* end, int) {
                  body.fluid_cells->sums[body.fluid_cells->place(cell)] =
                      scatter_fluid_cell<Shape>(fluid, body.points, cell, begin, end, grid);
                });
}

}  // namespace

void clear_empty_cells(Body& body, int b, const BackgroundGrid& grid) {
  const BrickPoints& points = body.cells.brick(b);
  const Brick& brick = grid.bricks()[b];
  for (int c = 0; c < Brick::cell_count; ++c) {
    if (points.begin[c] < points.begin[c + 1]) continue;
    const Cell cell = make_cell(grid, brick, c);
    bool exists = true;
    for (int axis = 0; axis < 3; ++axis) exists = exists && cell.index[axis] < grid.cells()[axis];
    if (!exists) continue;
    FluidSums& sums = body.fluid_cells->sums[body.fluid_cells->place(cell)];
    if (sums.volume != 0) sums = {};
  }
}

void scatter_brick(Body& body, int b, BackgroundGrid& grid) {
  if (body.fluid_cells) clear_empty_cells(body, b, grid);
  if (body.cells.brick(b).empty()) return;
  with_shape_functions(grid, [&](auto shape) {
    using Shape = decltype(shape);
    std::visit(
        [&](const auto& material) {
          if constexpr (std::is_same_v<std::decay_t<decltype(material)>, Fluid>) {
            if (body.fluid_cells) return scatter_fluid_cells<Shape>(material, body, b, grid);
          }
          if constexpr (can_average_volume<std::decay_t<decltype(material)>>) {
            if (body.average_volume_strain)
              return scatter_cells<Shape, Volumetric::averaged>(material, body, b, grid);
          }
          scatter_cells<Shape, Volumetric::own>(material, body, b, grid);
        },
        body.material);
  });
}

}  // namespace zona::mpm
