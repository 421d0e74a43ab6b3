#include "mpm/step/update.h"

#include <algorithm>

#include "mpm/grid/shape_functions.h"
#include "mpm/step/stages.h"

namespace zona::mpm {

namespace {

template <class Shape, bool averaged, class Material>
void update_cells(Material& material, Body& body, int b, double dt, const BackgroundGrid& grid,
                  std::vector<int>& invalid) {
  for_each_cell(
      grid, b, body.cells.brick(b), [&](const Cell& cell, const int* begin, const int* end, int) {
        update_cell<Shape, averaged>(material, body.points, cell, begin, end, dt, grid, invalid);
      });
}

template <class Shape, class Material>
void update_departing(Material& material, Body& body, int b, double dt, const BackgroundGrid& grid,
                      std::vector<int>& invalid) {
  for (const auto& [point, c] : body.cells.brick(b).departures) {
    const Cell cell = make_cell(grid, grid.bricks()[b], c);
    update_cell<Shape, false>(material, body.points, cell, &point, &point + 1, dt, grid, invalid);
  }
}

/// Updates the points that have not changed cells.
template <class Shape, class Material>
void update_settled(Material& material, Body& body, int b, double dt, const BackgroundGrid& grid,
                    std::vector<int>& invalid) {
  const BrickPoints& brick = body.cells.brick(b);
  const auto& arrivals = brick.arrivals;
  std::vector<int> settled;
  for_each_cell(grid, b, brick, [&](const Cell& cell, const int* begin, const int* end, int) {
    settled.clear();
    std::remove_copy_if(begin, end, std::back_inserter(settled), [&](int p) {
      return std::binary_search(arrivals.begin(), arrivals.end(), p);
    });
    update_cell<Shape, false>(material, body.points, cell, settled.data(),
                              settled.data() + settled.size(), dt, grid, invalid);
  });
}

template <class Shape, class Material>
void update_and_scatter_cells(Material& material, Body& body, int b, double dt,
                              BackgroundGrid& grid, std::vector<int>& invalid) {
  const BrickPoints& brick = body.cells.brick(b);
  if (!brick.arrivals.empty()) {
    update_settled<Shape>(material, body, b, dt, grid, invalid);
    return scatter_brick(body, b, grid);
  }
  for_each_cell_or_batch(
      grid, b, brick, Shape::few_points,
      [&](const Cell& cell, const int* begin, const int* end, int) {
        update_and_scatter_cell<Shape>(material, body.points, cell, begin, end, dt, grid, invalid);
      },
      [&](const Batch& batch) {
        update_and_scatter_batch(material, body.points, batch, dt, grid, invalid);
      });
}

}  // namespace

std::vector<int> update_brick(Body& body, int b, double dt, const BackgroundGrid& grid) {
  std::vector<int> invalid;
  with_shape_functions(grid, [&](auto shape) {
    using Shape = decltype(shape);
    std::visit(
        [&](auto& material) {
          using Material = std::decay_t<decltype(material)>;
          if constexpr (can_average_volume<Material>) {
            if (body.average_volume_strain)
              return update_cells<Shape, true>(material, body, b, dt, grid, invalid);
            update_departing<Shape>(material, body, b, dt, grid, invalid);
          } else if constexpr (Material::has_stress) {
            update_cells<Shape, false>(material, body, b, dt, grid, invalid);
          }
        },
        body.material);
  });
  return invalid;
}

std::vector<int> update_and_scatter_brick(Body& body, int b, double dt, BackgroundGrid& grid) {
  std::vector<int> invalid;
  with_shape_functions(grid, [&](auto shape) {
    using Shape = decltype(shape);
    std::visit(
        [&](auto& material) {
          using Material = std::decay_t<decltype(material)>;
          if constexpr (can_average_volume<Material>) {
            if (!body.average_volume_strain)
              return update_and_scatter_cells<Shape>(material, body, b, dt, grid, invalid);
          }
          scatter_brick(body, b, grid);
        },
        body.material);
  });
  return invalid;
}

}  // namespace zona::mpm
