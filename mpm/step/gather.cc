#include "mpm/step/gather.h"

#include "mpm/grid/shape_functions.h"
#include "mpm/step/stages.h"

namespace zona::mpm {

namespace {

template <class Shape, class Material, class Motion>
void gather_cells(Material& material, Body& body, int b, double dt, const Motion& motion,
                  BackgroundGrid& grid) {
  BrickPoints& brick = body.cells.brick(b);
  for_each_cell_or_batch(
      grid, b, brick, Shape::few_points,
      [&](const Cell& cell, const int* begin, const int* end, int c) {
        gather_cell<Shape>(material, body.points, cell, begin, end, c, dt, motion, brick, grid);
      },
      [&](const Batch& batch) {
        gather_batch(material, body.points, batch, dt, motion, brick, grid);
      });
}

}  // namespace

void gather_brick(Body& body, int b, double dt, double pic, BackgroundGrid& grid) {
  with_shape_functions(grid, [&](auto shape) {
    using Shape = decltype(shape);
    std::visit(
        [&](auto& material) {
          if constexpr (std::is_same_v<std::decay_t<decltype(material)>, Prescribed>) {
            Eigen::Vector3d& impulse = material.brick_impulse[b];
            impulse.setZero();
            gather_cells<Shape>(material, body, b, dt, PrescribedMotion{{pic}, impulse}, grid);
          } else if (pic > 0) {
            gather_cells<Shape>(material, body, b, dt, BlendedMotion{pic}, grid);
          } else {
            gather_cells<Shape>(material, body, b, dt, FreeMotion{}, grid);
          }
        },
        body.material);
  });
}

}  // namespace zona::mpm
