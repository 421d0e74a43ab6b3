#include "mpm/step/update.h"

#include <algorithm>

#include "mpm/grid/shape_functions.h"
#include "mpm/step/stages.h"

namespace zona::mpm {

namespace {

/// Rate of volumetric strain that an implicit pressure has given to a cell, else 0 [1/s].
double divergence_of(const Body& body, const Cell& cell) {
  return body.fluid_cells ? body.fluid_cells->divergence[body.fluid_cells->place(cell)] : 0;
}

template <class Shape, Volumetric kind, class Material>
void update_cells(Material& material, Body& body, int b, double dt, const BackgroundGrid& grid,
                  std::vector<int>& invalid) {
  for_each_cell(
      grid, b, body.cells.brick(b), [&](const Cell& cell, const int* begin, const int* end, int) {
        update_cell<Shape, kind>(material, body.points, cell, begin, end, dt, 0, grid, invalid);
      });
}

template <class Shape, Volumetric kind, class Material>
void update_departing(Material& material, Body& body, int b, double dt, const BackgroundGrid& grid,
                      std::vector<int>& invalid) {
  for (const auto& [point, c] : body.cells.brick(b).departures) {
    const Cell cell = make_cell(grid, grid.bricks()[b], c);
    update_cell<Shape, kind>(material, body.points, cell, &point, &point + 1, dt,
                             divergence_of(body, cell), grid, invalid);
  }
}

/// Updates the points that have not changed cells.
template <class Shape, Volumetric kind, class Material>
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
    update_cell<Shape, kind>(material, body.points, cell, settled.data(),
                             settled.data() + settled.size(), dt, divergence_of(body, cell), grid,
                             invalid);
  });
}

template <class Shape, class Material>
void update_and_scatter_cells(Material& material, Body& body, int b, double dt,
                              BackgroundGrid& grid, std::vector<int>& invalid) {
  for_each_cell_or_batch(
      grid, b, body.cells.brick(b), Shape::few_points,
      [&](const Cell& cell, const int* begin, const int* end, int) {
        update_and_scatter_cell<Shape>(material, body.points, cell, begin, end, dt, grid, invalid);
      },
      [&](const Batch& batch) {
        update_and_scatter_batch(material, body.points, batch, dt, grid, invalid);
      });
}

template <class Shape>
void update_and_scatter_fluid(Fluid& fluid, Body& body, int b, double dt, BackgroundGrid& grid,
                              std::vector<int>& invalid) {
  FluidCells& cells = *body.fluid_cells;
  clear_empty_cells(body, b, grid);
  for_each_cell(
      grid, b, body.cells.brick(b), [&](const Cell& cell, const int* begin, const int* end, int) {
        const long place = cells.place(cell);
        cells.sums[place] = update_and_scatter_fluid_cell<Shape>(
            fluid, body.points, cell, begin, end, dt, cells.divergence[place], grid, invalid);
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
          if constexpr (std::is_same_v<Material, Fluid>) {
            if (body.fluid_cells) {
              return update_departing<Shape, Volumetric::implicit>(material, body, b, dt, grid,
                                                                   invalid);
            }
          }
          if constexpr (can_average_volume<Material>) {
            if (body.average_volume_strain) {
              return update_cells<Shape, Volumetric::averaged>(material, body, b, dt, grid,
                                                               invalid);
            }
            update_departing<Shape, Volumetric::own>(material, body, b, dt, grid, invalid);
          } else if constexpr (Material::has_stress) {
            update_cells<Shape, Volumetric::own>(material, body, b, dt, grid, invalid);
          }
        },
        body.material);
  });
  return invalid;
}

std::vector<int> update_and_scatter_brick(Body& body, int b, double dt, BackgroundGrid& grid) {
  std::vector<int> invalid;
  const bool settled = body.cells.brick(b).arrivals.empty();
  with_shape_functions(grid, [&](auto shape) {
    using Shape = decltype(shape);
    std::visit(
        [&](auto& material) {
          using Material = std::decay_t<decltype(material)>;
          if constexpr (std::is_same_v<Material, Fluid>) {
            if (body.fluid_cells && settled)
              return update_and_scatter_fluid<Shape>(material, body, b, dt, grid, invalid);
            if (body.fluid_cells) {
              update_settled<Shape, Volumetric::implicit>(material, body, b, dt, grid, invalid);
              return scatter_brick(body, b, grid);
            }
          }
          if constexpr (can_average_volume<Material>) {
            if (!body.average_volume_strain) {
              if (settled)
                return update_and_scatter_cells<Shape>(material, body, b, dt, grid, invalid);
              update_settled<Shape, Volumetric::own>(material, body, b, dt, grid, invalid);
            }
          }
          scatter_brick(body, b, grid);
        },
        body.material);
  });
  return invalid;
}

}  // namespace zona::mpm
