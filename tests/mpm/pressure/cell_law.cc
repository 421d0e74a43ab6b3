#include "mpm/pressure/cell_law.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace zona::mpm;

namespace {

/// Points of one cell with scattered states, their masses [kg] and their sums.
struct Points {
  MaterialPoints points;
  Fluid fluid;
  std::vector<int> all;
  FluidSums sums;

  explicit Points(const FluidProperties& properties)
      : points(make_points(std::vector<Eigen::Vector3d>(11, {0.3, 0.6, 0.2}),
                           std::vector<double>(11, 1.0))),
        fluid(properties, 11) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(0.9, 1.1);
    CellSummation summation;
    for (int p = 0; p < 11; ++p) {
      all.push_back(p);
      points.mass[p] *= part(random);
      fluid.density[p] *= part(random);
      fluid.internal_energy[p] *= part(random);
      const double pressure = properties.state.pressure(fluid.density[p], fluid.internal_energy[p]);
      for (int i = 0; i < 3; ++i) fluid.stress[i][p] = -pressure;
    }
    for_each_group(all.data(), all.data() + 11, [&](const PointGroup& group) {
      summation.add(fluid, points, group, group.load(points.position));
    });
    sums = summation.sums();
  }

  /// Mean pressure by volume after a step with a volumetric strain.
  double pressure_after(double strain, double dt, double length) {
    Fluid changed = fluid;
    VelocityGradient gradient{};
    for (int i = 0; i < 3; ++i) gradient[i][i] = broadcast(strain / dt / 3);
    for_each_group(all.data(), all.data() + 11,
                   [&](const PointGroup& group) { changed.update(group, gradient, dt, length); });
    double sum = 0;
    double volume = 0;
    for (int p = 0; p < 11; ++p) {
      const double v = points.mass[p] / changed.density[p];
      sum -= v * (changed.stress[0][p] + changed.stress[1][p] + changed.stress[2][p]) / 3;
      volume += v;
    }
    return sum / volume;
  }
};

FluidProperties gas(EnergyIncrement increment, ArtificialViscosity artificial = {}) {
  return {1.2, StiffenedGas::ideal_gas(1.4), 1e5, 0, artificial, increment};
}

}  // namespace

TEST_CASE("The pressure of a cell is the mean of its points after the step") {
  const double dt = 1e-5;
  const double length = 0.02;
  for (const FluidProperties& properties :
       {gas(EnergyIncrement::end_pressure), gas(EnergyIncrement::mean_pressure),
        gas(EnergyIncrement::mean_pressure, {2, 1}),
        FluidProperties{1000, {4, 6.13e8}, 2e5, 0, {}}}) {
    Points cell(properties);
    const CellLaw law(properties, cell.sums, dt, length);
    for (const double strain : {-0.1, -1e-3, 0.0, 1e-5, 0.3}) {
      const double scale = law.stiffness(0);
      CHECK(std::abs(law.pressure(strain) - cell.pressure_after(strain, dt, length)) <
            1e-12 * scale);
      if (strain == 0) continue;  // artificial viscosity has a kink there
      const double step = 1e-6 * std::abs(strain);
      const double slope = (law.pressure(strain + step) - law.pressure(strain - step)) / (2 * step);
      CHECK(-slope == Approx(law.stiffness(strain)).epsilon(1e-5));
    }
  }
}

TEST_CASE("A cell is as stiff as density times the square of the speed of sound") {
  const FluidProperties water{1000, {4, 6.13e8}, 2e5, 0, {}};
  const int points = 5;
  FluidSums sums;
  sums.volume = 1e-9;
  sums.mass = 1e-6;
  sums.energy = sums.mass * water.state.internal_energy(water.pressure, water.density);
  sums.pressure = sums.volume * water.pressure;
  const Fluid fluid(water, points);
  const double c = fluid.wave_speed();
  CHECK(CellLaw(water, sums, 1e-9, 1e-6).stiffness(0) == Approx(1000 * c * c).epsilon(1e-12));
}
