#include <catch2/catch.hpp>

#include "bar_model.h"
#include "vortex_model.h"

using namespace zona::mpm;
using F = FaceCondition;

namespace {

struct BarErrors {
  double velocity, stress;  ///< root mean square over the points, relative to the amplitude
};

/// A free bar of n cells, length 1, wave speed 1, swings lengthwise in its first mode and drifts
/// through the grid meanwhile. Strains of 1e-4: the linear solution is exact.
BarErrors drifting_bar(int n, Interpolation interpolation, double drift) {
  const double h = 1.0 / n, amplitude = 1e-4, k = M_PI, dt = 0.2 * h;
  BarModel bar(2 * n + 4, h, interpolation);
  Model model{bar.grid, {}, BarModel::faces(F::free, F::free), Eigen::Vector3d::Zero()};
  const double begin = 2 * h;
  auto points = bar.points(begin, begin + 1, {3, 1, 1}, 1);
  std::vector<double> x;
  for (int p = 0; p < points.size(); ++p) {
    x.push_back(points.position[0][p] - begin);
    points.velocity[0][p] = drift + amplitude * std::cos(k * x[p]);
  }
  LinearElastic solid({1, 1, 0}, points.size());
  model.bodies.push_back({"bar", std::move(points), std::move(solid), {}});
  Solver solver(std::move(model), dt);
  while (solver.time() < 1.75 - 1e-9) solver.step();
  const auto& body = solver.bodies()[0];
  const auto& stress = std::get<LinearElastic>(body.material).stress[0];
  BarErrors squares{0, 0};
  for (int p = 0; p < body.points.size(); ++p) {
    const double at = k * x[body.points.id[p]];
    // Velocities stand half a step before positions and stresses.
    const double v = std::cos(at) * std::cos(k * (solver.time() - dt / 2));
    const double sigma = -std::sin(at) * std::sin(k * solver.time());
    squares.velocity += std::pow((body.points.velocity[0][p] - drift) / amplitude - v, 2);
    squares.stress += std::pow(stress[p] / amplitude - sigma, 2);
  }
  const double count = body.points.size();
  return {std::sqrt(squares.velocity / count), std::sqrt(squares.stress / count)};
}

}  // namespace

TEST_CASE("A bar that drifts through the cells: quadratic functions converge, linear ones stall") {
  const auto linear = Interpolation::linear, quadratic = Interpolation::quadratic;
  // At rest both converge: velocity at second order, the stress of linear functions at first.
  for (auto shape : {linear, quadratic}) {
    const BarErrors coarse = drifting_bar(20, shape, 0), fine = drifting_bar(80, shape, 0);
    INFO(coarse.velocity << " " << fine.velocity << ", " << coarse.stress << " " << fine.stress);
    CHECK(std::log2(coarse.velocity / fine.velocity) / 2 > 1.8);
    CHECK(std::log2(coarse.stress / fine.stress) / 2 > (shape == linear ? 0.9 : 1.9));
  }
  // Thirty cells crossed in the finer grid: nothing changes for quadratic functions.
  const BarErrors coarse = drifting_bar(20, quadratic, 0.25);
  const BarErrors fine = drifting_bar(80, quadratic, 0.25);
  const BarErrors stalled = drifting_bar(80, linear, 0.25);
  INFO(coarse.velocity << " " << fine.velocity << ", " << coarse.stress << " " << fine.stress
                       << "; linear " << stalled.velocity << ", " << stalled.stress);
  CHECK(std::log2(coarse.velocity / fine.velocity) / 2 > 1.8);
  CHECK(std::log2(coarse.stress / fine.stress) / 2 > 1.9);
  CHECK(stalled.velocity > 8 * fine.velocity);
  CHECK(stalled.stress > 10 * fine.stress);
}

TEST_CASE("Quadratic functions quiet the pressure of a vortex without averaging") {
  const auto after = [](Interpolation interpolation) {
    const VortexModel vortex{8, 3, false, 0.01, 0, interpolation};
    Solver solver = vortex.solver();
    while (solver.time() < 0.5) solver.step();
    return std::pair(vortex.error(solver), cell_averaged_pressure(solver.bodies()[0]).scatter);
  };
  const auto [error, scatter] = after(Interpolation::linear);
  const auto [error_quadratic, scatter_quadratic] = after(Interpolation::quadratic);
  INFO("velocity error " << error << " -> " << error_quadratic << ", scatter " << scatter << " -> "
                         << scatter_quadratic);
  CHECK(error_quadratic < 0.7 * error);
  CHECK(scatter_quadratic < 0.2 * scatter);
}
