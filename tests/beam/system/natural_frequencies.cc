#include <catch2/catch.hpp>
#include <cmath>

#include "beam/exact/cantilever.h"
#include "beam/system/natural_modes.h"
#include "tests/beam/cases.h"

using namespace zona::beam;

TEST_CASE("twenty elements give the six frequencies of Table 5.6") {
  const double table[] = {27.729, 173.791, 486.666, 953.692, 1576.353, 2354.919};
  const auto frequency = natural_modes(cantilever(test::pipette_with("mercury"))).frequency();
  // The table deviates from (5.72) by up to 0.011 %, the elements by (1.7/2)^4/1440 = 0.03 % for
  // mode 6.
  for (int n = 0; n < 6; ++n) CHECK(frequency(n) == Approx(table[n]).epsilon(1e-3));
}

TEST_CASE("modes are orthogonal in mass and stiffness, and mass-normalised") {
  const BeamSystem system = cantilever(test::pipette_with("water"));
  const NaturalModes modes = natural_modes(system);
  const Eigen::MatrixXd unit = modes.shape.transpose() * system.mass.dense() * modes.shape;
  const Eigen::MatrixXd squares = modes.shape.transpose() * system.stiffness.dense() * modes.shape;
  const Eigen::ArrayXd omega = modes.angular_frequency.array();
  // A backward stable solver errs by size * rounding of the greatest eigenvalue.
  CHECK((unit - Eigen::MatrixXd::Identity(40, 40)).cwiseAbs().maxCoeff() < 1e-12);
  const Eigen::MatrixXd expected = omega.square().matrix().asDiagonal();
  CHECK((squares - expected).cwiseAbs().maxCoeff() < 1e-12 * omega.square().maxCoeff());
}

TEST_CASE("frequencies converge from above with the fourth power of the element length") {
  const Pipette pipette = test::pipette_with("mercury");
  const ExactCantilever exact(uniform_beam(pipette), 4);
  for (int mode = 2; mode <= 4; ++mode) {
    double coarse_error = 0;
    for (const int elements : {10, 20, 40}) {
      const auto modes = natural_modes(cantilever(test::pipette_with("mercury", elements)));
      const double error = modes.angular_frequency(mode - 1) / exact.angular_frequency(mode) - 1;
      CHECK(error > 0);
      // Known dispersion of cubic elements: omega_h / omega = 1 + (alpha h)^4 / 1440 + O(h^6), here
      // with alpha h <= 1.1, so the next term is below a fifth.
      const double phase = exact.root(mode) / elements;
      CHECK(error == Approx(std::pow(phase, 4) / 1440).epsilon(0.2));
      if (coarse_error > 0) CHECK(std::log2(coarse_error / error) == Approx(4).margin(0.15));
      coarse_error = error;
    }
  }
}

namespace {

/// First root of J_m I_(m+1) + I_m J_(m+1), by bisection in a bracket that holds only that root.
double taper_root(int m, double low, double high) {
  const auto f = [m](double z) {
    return std::cyl_bessel_j(m, z) * std::cyl_bessel_i(m + 1, z) +
           std::cyl_bessel_i(m, z) * std::cyl_bessel_j(m + 1, z);
  };
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (f(low) * f(middle) <= 0 ? high : low) = middle;
  }
  return low;
}

}  // namespace

TEST_CASE("a wedge and a cone vibrate as Kirchhoff found in 1879") {
  // A section that shrinks linearly to a point: omega l^2 sqrt(rho_bar / EI at the root) = z^2 / 4.
  struct Taper {
    int mass_power, rigidity_power, order;
  };
  for (const Taper taper : {Taper{1, 3, 1}, Taper{2, 4, 2}}) {
    const double z = taper_root(taper.order, taper.order + 3, taper.order + 4.5);
    const auto power = [](int exponent) {
      return [exponent](double x) { return std::pow(1 - x, exponent); };
    };
    const Section section{1, power(taper.rigidity_power), power(taper.mass_power)};
    const auto modes = natural_modes(assemble(section, {40, Supports::clamped_free, 1}));
    // The tip element alone is not resolved; halving it changes the result by less than this.
    CHECK(modes.angular_frequency(0) == Approx(z * z / 4).epsilon(1e-6));
  }
}
