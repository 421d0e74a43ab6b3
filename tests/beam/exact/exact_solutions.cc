#include <catch2/catch.hpp>
#include <cmath>

#include "beam/exact/cantilever.h"
#include "tests/beam/cases.h"

using namespace zona::beam;

namespace {

const UniformBeam unit_beam{1, 1, 1};

/// Integral of f over [0, 1] by Simpson's rule.
template <class Function>
double integral(Function&& f, int intervals) {
  double sum = f(0.) + f(1.);
  for (int i = 1; i < intervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(double(i) / intervals);
  return sum / (3 * intervals);
}

}  // namespace

TEST_CASE("roots satisfy the frequency equation (5.70)") {
  const ExactCantilever exact(unit_beam, 2000);
  // Values of handbooks, to their digits.
  CHECK(exact.root(1) == Approx(1.875104069).epsilon(1e-9));
  CHECK(exact.root(2) == Approx(4.694091133).epsilon(1e-9));
  CHECK(exact.root(3) == Approx(7.854757438).epsilon(1e-9));
  for (int n = 1; n <= 10; ++n) {
    // cosh z cos z has slope cosh z, so rounding of z leaves z cosh z rounding units.
    const double z = exact.root(n);
    CHECK(std::abs(std::cosh(z) * std::cos(z) + 1) < 4e-16 * z * std::cosh(z));
  }
  CHECK(exact.root(2000) == Approx(1999.5 * M_PI).epsilon(1e-15));
}

TEST_CASE("mode shapes satisfy the boundary conditions, are orthonormal and never overflow") {
  const ExactCantilever exact(unit_beam, 2000);
  for (const int n : {1, 2, 7, 80, 2000}) {
    CHECK(std::abs(exact.shape(n, 0)) < 1e-13);
    CHECK(exact.shape(n, 1) == Approx(n % 2 == 1 ? 2 : -2).epsilon(1e-11));
    CHECK(std::isfinite(exact.shape(n, 0.5)));
  }
  for (const int m : {1, 2, 20})
    for (const int n : {1, 2, 20}) {
      const auto product = [&](double x) { return exact.shape(m, x) * exact.shape(n, x); };
      // Simpson's error is (120/2000)^4/180 for the product of two modes 20.
      CHECK(integral(product, 2000) == Approx(m == n ? 1 : 0).margin(1e-6));
    }
}

TEST_CASE("tip shares are the mean of the mode times its tip value and sum to the rigid motion") {
  const ExactCantilever exact(unit_beam, 2000);
  for (const int n : {1, 2, 9}) {
    const double mean = integral([&](double x) { return exact.shape(n, x); }, 2000);
    CHECK(exact.tip_share(n) == Approx(mean * exact.shape(n, 1)).epsilon(1e-7));
  }
  // Alternating series with terms 4 / root: the remainder is at most the first omitted term.
  double sum = 0;
  for (int n = 1; n <= exact.modes(); ++n) sum += exact.tip_share(n);
  CHECK(std::abs(sum - 1) < 4 / exact.root(2000));
}

TEST_CASE("the history equals the modal sum that it replaces") {
  const ExactCantilever exact(uniform_beam(test::pipette_with("water")), 80);
  const RayleighDamping damping{50, 1e-7};
  const auto pulse = triangular_pulse(1, 61.7e-6);
  const Sampling sampling{1e-3, 0.6e-6};
  const TipHistory history = exact.tip_history(pulse, sampling, damping);
  const auto all_kinks = kinks(pulse);
  for (std::size_t i = 0; i < history.time.size(); i += 7) {
    const RelativeMotion direct = exact.tip_relative(all_kinks, history.time[i], damping);
    // Rounding of the phase omega t, at most 2e7 rad/s * 1 ms, times the amplitudes and their
    // rates.
    CHECK(history.displacement[i] - history.support[i] ==
          Approx(direct.displacement).margin(1e-10));
    CHECK(history.velocity[i] - velocity(pulse, history.time[i]) ==
          Approx(direct.velocity).margin(1e-5));
  }
}

TEST_CASE("eighty modes give the amplitudes known for a 60 us pulse") {
  // Independent calculation of the ratios of *absolute* tip displacement; those of relative
  // displacement are 1.03, 1.00, 1.00, 1.00.
  const struct {
    const char* fluid;
    double ratio, half_digit;
  } known[] = {{"none", 1.03, 0.005},
               {"water", 0.96, 0.005},
               {"fluorinert", 0.92, 0.005},
               {"mercury", 0.755, 0.0005}};
  const auto pulse = triangular_pulse(17.9e-6, 60e-6);
  for (const auto& [fluid, ratio, half_digit] : known) {
    const ExactCantilever exact(uniform_beam(test::pipette_with(fluid)), 80);
    CHECK(amplitude_ratio(exact.tip_history(pulse, Sampling{}), 17.9e-6) ==
          Approx(ratio).margin(half_digit));
  }
}

TEST_CASE("the tip hardly moves in the first 100 us") {
  // Bending waves are dispersive: the fastest of the 80 modes reach the tip early, with tiny
  // amplitudes.
  const ExactCantilever exact(uniform_beam(test::pipette_with("mercury")), 1000);
  const TipHistory history = exact.tip_history(triangular_pulse(1, 60e-6), {5e-3, 0.6e-6});
  for (std::size_t i = 0; history.time[i] < 100e-6; ++i)
    CHECK(std::abs(history.displacement[i]) < 0.05);
}
