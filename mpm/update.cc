#include "mpm/gather.h"
#include "mpm/shape_functions.h"
#include "mpm/stages.h"

namespace zona::mpm {

namespace {

template <class Shape, bool averaged, class Material>
void update_cells(Material& material, Body& body, int b, double dt, const BackgroundGrid& grid,
                  std::vector<int>& bad) {
  for_each_cell(
      grid, b, body.cells.brick(b), [&](const Cell& cell, const int* begin, const int* end, int) {
        update_cell<Shape, averaged>(material, body.points, cell, begin, end, dt, grid, bad);
      });
}

}  // namespace

std::vector<int> update_brick(Body& body, int b, double dt, const BackgroundGrid& grid) {
  std::vector<int> bad;
  with_shape_functions(grid, [&](auto shape) {
    using Shape = decltype(shape);
    std::visit(
        [&](auto& material) {
          using Material = std::decay_t<decltype(material)>;
          if constexpr (can_average_volume<Material>) {
            if (body.average_volume_strain)
              return update_cells<Shape, true>(material, body, b, dt, grid, bad);
          }
          if constexpr (Material::has_stress)
            update_cells<Shape, false>(material, body, b, dt, grid, bad);
        },
        body.material);
  });
  return bad;
}

}  // namespace zona::mpm
