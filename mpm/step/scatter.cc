#include "mpm/step/scatter.h"

#include "mpm/grid/shape_functions.h"
#include "mpm/step/stages.h"

namespace zona::mpm {

namespace {

template <class Shape, bool averaged, class Material>
void scatter_cells(const Material& material, const Body& body, int b, BackgroundGrid& grid) {
  for_each_cell_or_batch(
      grid, b, body.cells.brick(b), averaged ? 0 : Shape::few_points,
      [&](const Cell& cell, const int* begin, const int* end, int) {
        scatter_cell<Shape, averaged>(material, body.points, cell, begin, end, grid);
      },
      [&](const Batch& batch) { scatter_batch(material, body.points, batch, grid); });
}

}  // namespace

void scatter_brick(const Body& body, int b, BackgroundGrid& grid) {
  with_shape_functions(grid, [&](auto shape) {
    using Shape = decltype(shape);
    std::visit(
        [&](const auto& material) {
          if constexpr (can_average_volume<std::decay_t<decltype(material)>>) {
            if (body.average_volume_strain)
              return scatter_cells<Shape, true>(material, body, b, grid);
          }
          scatter_cells<Shape, false>(material, body, b, grid);
        },
        body.material);
  });
}

}  // namespace zona::mpm
