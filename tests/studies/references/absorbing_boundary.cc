#include "studies/references/absorbing_boundary.h"

#include <catch2/catch.hpp>
#include <complex>

using namespace zona::studies::references;

TEST_CASE("viscous boundary: known reflections") {
  const double degree = 0.017453292519943295;
  CHECK(reflected_pressure(0) == 0);
  CHECK(reflected_pressure(60 * degree) == Approx(-1.0 / 3));
  CHECK(reflected_pressure(90 * degree) == Approx(-1).epsilon(1e-12));
  CHECK(reflected_pressure(45 * degree) == Approx(-0.171573).epsilon(1e-5));
  CHECK(reflected_pressure(0, 0) == -1);                        // free
  CHECK(reflected_pressure(0, 1e12) == Approx(1));              // rigid
  CHECK(std::abs(reflected_pressure(60 * degree, 2)) < 1e-12);  // tuned to an angle
  CHECK_THROWS_AS(reflected_pressure(-0.1), zona::mpm::ModelError);
}

TEST_CASE("viscous boundary: the superposed waves satisfy it at any time and place") {
  // phi is a velocity potential: v = grad phi, p = -rho phi_t, incoming and reflected plane waves.
  using Complex = std::complex<double>;
  const double rho = 1000, c = 1500, omega = 3e4, k = omega / c;
  for (double angle : {0.1, 0.7, 1.3}) {
    const double reflected = reflected_pressure(angle);
    for (double y : {0.0, 0.02, 0.05}) {
      const Complex phase = std::exp(Complex(0, k * std::sin(angle) * y - omega * 1e-5));
      const Complex pressure = Complex(0, rho * omega) * phase * (1 + reflected);
      const Complex velocity = Complex(0, k * std::cos(angle)) * phase * (1 - reflected);
      CHECK(std::abs(pressure - rho * c * velocity) / std::abs(rho * c * velocity) < 1e-12);
    }
  }
}

TEST_CASE("viscous boundary: what is not reflected is dissipated") {
  for (double angle : {0.0, 0.4, 1.2}) {
    const double r = reflected_pressure(angle);
    const double power_in = std::cos(angle) * (1 - r * r);     // of p^2/(rho c)
    const double normal_velocity = (1 - r) * std::cos(angle);  // of p/(rho c)
    CHECK(normal_velocity * normal_velocity == Approx(power_in));
  }
}
