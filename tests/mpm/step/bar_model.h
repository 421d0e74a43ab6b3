#pragma once

#include "mpm/bodies/lattice.h"
#include "mpm/step/solver.h"

/// A tube of n x 1 x 1 cells along x with sliding walls: one-dimensional flow in three dimensions.
struct BarModel {
  zona::mpm::BackgroundGrid grid;

  BarModel(int n, double cell,
           zona::mpm::Interpolation interpolation = zona::mpm::Interpolation::linear)
      : grid(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(cell), {n, 1, 1}, interpolation) {}

  /// Points of cells with low <= x < high, `per_cell` of them.
  zona::mpm::MaterialPoints points(double low, double high, std::array<int, 3> per_cell,
                                   double density, double speed = 0) const {
    const auto lattice = zona::mpm::fill_cells(
        grid, per_cell, [&](const Eigen::Vector3d& x) { return x.x() >= low && x.x() < high; });
    std::vector<double> mass;
    for (double v : lattice.volumes) mass.push_back(density * v);
    return zona::mpm::make_points(lattice.places, mass, Eigen::Vector3d(speed, 0, 0));
  }
  static zona::mpm::FaceConditions faces(zona::mpm::FaceCondition low,
                                         zona::mpm::FaceCondition high) {
    using F = zona::mpm::FaceCondition;
    return {low, high, F::roller, F::roller, F::roller, F::roller};
  }
};
