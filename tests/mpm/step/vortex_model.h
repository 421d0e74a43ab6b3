#pragma once

#include "mpm/bodies/lattice.h"
#include "mpm/results/diagnostics.h"
#include "mpm/step/solver.h"

/// Decaying Taylor-Green vortex in a box of 1 m whose walls slide: an exact solution of the
/// Navier-Stokes equations, v = e^(-2 nu k^2 t) (sin kx cos kz, -cos kx sin kz), k = pi / m, for a
/// fluid of 1 kg/m^3, here slightly compressible (Mach 0.05).
struct VortexModel {
  int cells;
  int per_cell = 3;
  bool average_volume_strain = false;
  double viscosity = 0.01;  ///< [Pa s]
  double pic = 0;
  zona::mpm::Interpolation interpolation = zona::mpm::Interpolation::linear;
  zona::mpm::EnergyIncrement energy_increment = zona::mpm::EnergyIncrement::end_pressure;
  static constexpr double sound = 20, k = M_PI;

  zona::mpm::Solver solver() const {
    using namespace zona::mpm;
    using F = FaceCondition;
    const double h = 1.0 / cells;
    BackgroundGrid grid(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(h), {cells, 1, cells},
                        interpolation);
    const auto lattice = fill_cells(grid, {per_cell, per_cell, per_cell},
                                    [](const Eigen::Vector3d&) { return true; });
    const StiffenedGas state{4, sound * sound / 5};
    auto points = make_points(lattice.places, lattice.volumes);
    Fluid fluid({1, state, 0, viscosity, {}, energy_increment}, points.size());
    for (int p = 0; p < points.size(); ++p) {
      const Eigen::Vector3d x = points.position_of(p), v = velocity(x, 0);
      const double pressure = 0.25 * (std::cos(2 * k * x.x()) + std::cos(2 * k * x.z()));
      for (int axis = 0; axis < 3; ++axis) {
        points.velocity[axis][p] = v[axis];
        fluid.stress[axis][p] = -pressure;
      }
      fluid.density[p] = 1 + pressure / (sound * sound);
      points.mass[p] *= fluid.density[p];
      fluid.internal_energy[p] = state.internal_energy(pressure, fluid.density[p]);
    }
    Model model{grid,
                {},
                {F::roller, F::roller, F::roller, F::roller, F::roller, F::roller},
                Eigen::Vector3d::Zero()};
    model.numerics.pic = pic;
    model.bodies.push_back(
        {"fluid", std::move(points), std::move(fluid), {}, average_volume_strain});
    return Solver(std::move(model), 0.4 * h / sound);
  }
  Eigen::Vector3d velocity(const Eigen::Vector3d& x, double t) const {
    const double left = std::exp(-2 * viscosity * k * k * t);
    return {left * std::sin(k * x.x()) * std::cos(k * x.z()), 0,
            -left * std::cos(k * x.x()) * std::sin(k * x.z())};
  }
  /// Root mean square error of the points' velocity; the vortex began with at most 1 m/s.
  double error(const zona::mpm::Solver& solver) const {
    double squares = 0;
    const auto& points = solver.bodies()[0].points;
    for (int p = 0; p < points.size(); ++p) {
      squares +=
          (points.velocity_of(p) - velocity(points.position_of(p), solver.time())).squaredNorm();
    }
    return std::sqrt(squares / points.size());
  }
};
