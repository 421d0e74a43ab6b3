#include "studies/references/axisymmetric_membrane.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mpm/points/errors.h"
#include "studies/references/hencky_membrane.h"
#include "studies/references/inflated_disc.h"
#include "studies/references/inflated_sphere.h"
#include "studies/references/meridian_element.h"

using namespace zona::studies::references;
using Eigen::Vector4d;
using zona::mpm::ModelError;

namespace {

constexpr double pi = 3.14159265358979323846;
const MembraneLaw law{1e6, 0.3, 1e-3};

/// A sphere from pole to pole; the lower pole is held.
struct Sphere {
  Meridian meridian;
  MeridianLoads loads;
  MeridianState state;

  Sphere(const MembraneLaw& l, double radius, int elements) {
    meridian.law = l;
    meridian.reference = Eigen::VectorXd::Zero(2 * elements + 2);
    int count = 0;
    for (int i = 0; i <= elements; ++i) {
      const bool pole = i == 0 || i == elements;
      const double angle = pi * i / elements;
      meridian.reference[2 * i] = pole ? 0 : radius * std::sin(angle);
      meridian.reference[2 * i + 1] = -radius * std::cos(angle);
      loads.unknown.push_back(pole ? -1 : count++);
      loads.unknown.push_back(i == 0 ? -1 : count++);
    }
    state.position = 1.02 * meridian.reference;
    state.position[1] = meridian.reference[1];
  }
};

}  // namespace

TEST_CASE("meridian element: volume, stretches, and forces as derivatives") {
  const Vector4d reference(0.5, 0.1, 0.7, 0.4), now(0.55, 0.15, 0.8, 0.5);
  const auto derivative = [&](auto value, int i) {
    const double step = 1e-5;
    const Vector4d d = step * Vector4d::Unit(i);
    return (value(now + d) - value(now - d)) / (2 * step);
  };
  const double length = (reference.tail<2>() - reference.head<2>()).norm();
  const auto volume = element_volume(now);
  const auto stretch = meridional_stretch(now, length);
  const double area = pi * 1.2 * length;
  const auto energy = [&](const Vector4d& x) {
    return area * stored_energy(law, meridional_stretch(x, length).value, (x[0] + x[2]) / 1.2);
  };
  const auto forces = [&](const Vector4d& x) {
    return element_forces(law, 0, reference, x, strain_of_stretches(law.strain, reference, x));
  };
  // By sums over slices.
  double slices = 0;
  for (int i = 0; i < 1000; ++i) {
    const double s = (i + 0.5) / 1000, r = 0.55 + 0.25 * s;
    slices += pi * r * r * 0.35 / 1000;
  }
  CHECK(volume.value == Approx(slices).epsilon(1e-6));
  const auto f = forces(now);
  for (int i = 0; i < 4; ++i) {
    const double rounding = 1e-8;
    CHECK(volume.gradient[i] ==
          Approx(derivative([](const Vector4d& x) { return element_volume(x).value; }, i))
              .margin(rounding));
    CHECK(stretch.gradient[i] ==
          Approx(
              derivative([&](const Vector4d& x) { return meridional_stretch(x, length).value; }, i))
              .margin(rounding));
    CHECK(f.force[i] == Approx(derivative(energy, i)).margin(1e3 * rounding));
    for (int j = 0; j < 4; ++j) {
      CHECK(volume.second(j, i) ==
            Approx(derivative([&](const Vector4d& x) { return element_volume(x).gradient[j]; }, i))
                .margin(rounding));
      CHECK(f.stiffness(j, i) ==
            Approx(derivative([&](const Vector4d& x) { return forces(x).force[j]; }, i))
                .margin(1e3 * rounding));
    }
  }
}

TEST_CASE("meridian element: summed strains of a turn are those of (4.4), (4.5)") {
  // A turn by `angle` without stretch is seen as sin^2(angle)/2; none is real.
  Vector4d sum = Vector4d::Zero(), last(1, 0, 2, 0);
  const double angle = 0.5;
  for (int i = 1; i <= 1000; ++i) {
    const double a = angle * i / 1000;
    const Vector4d now(1, 0, 1 + std::cos(a), std::sin(a));
    if (i == 1000) {
      const auto strain = strain_of_sum(sum, last, now);
      CHECK(strain.along == Approx(0.5 * std::pow(std::sin(angle), 2)).epsilon(1e-5));
      CHECK(strain.around == Approx(std::log((2 + std::cos(angle)) / 3)).epsilon(1e-5));
    }
    sum = summed_strain(sum, last, now);
    last = now;
  }
}

TEST_CASE("axisymmetric membrane: the inflated sphere, second order") {
  const double radius = 0.05, pressure = 0.5 * sphere_pressure(law, radius, 1.1);
  const double exact = sphere_stretch(law, radius, pressure);
  const auto stretch = [&](int elements, bool summed) {
    Sphere s(law, radius, elements);
    s.meridian.summed = summed;
    s.loads.pressure = pressure;
    find_equilibrium(s.meridian, s.loads, s.state);
    return s.state.position[elements] / radius;  // at the equator
  };
  const double coarse = std::abs(stretch(40, false) - exact),
               fine = std::abs(stretch(80, false) - exact);
  CHECK(fine < 1e-4);
  CHECK(coarse / fine == Approx(4).epsilon(0.1));
  // Nothing turns: the increments sum to the logarithmic strain, to third order in the one step.
  CHECK(stretch(80, true) == Approx(stretch(80, false)).epsilon(1e-4));
}

TEST_CASE("axisymmetric membrane: a filled sphere keeps its volume") {
  Sphere s(law, 0.05, 60);
  s.loads.filled = true;
  s.loads.volume = 1.1 * enclosed_volume(s.meridian.reference);
  s.loads.bulk_modulus = 1e5;
  find_equilibrium(s.meridian, s.loads, s.state);
  CHECK(enclosed_volume(s.state.position) ==
        Approx(s.loads.volume * (1 - s.state.pressure / 1e5)).epsilon(1e-10));
  const double stretch = std::cbrt(1.1 * (1 - s.state.pressure / 1e5));
  CHECK(s.state.pressure == Approx(sphere_pressure(law, 0.05, stretch)).epsilon(2e-3));
}

TEST_CASE("inflated disc: Hencky's for small loads, stiffer law of large ones") {
  double last = 1;
  for (double pressure : {1.0, 0.1, 0.01}) {
    const HenckyMembrane hencky({0.1, 1e-3, 1e6, 0.3, pressure});
    const auto disc = inflate_disc(law, 0.1, pressure, 400);
    const double difference = disc.deflection / hencky.deflection(0) - 1;
    // The square of the slope, which falls with the load to 2/3.
    CHECK(std::abs(difference) < std::pow(pressure * 0.1 / 1e3, 2.0 / 3));
    CHECK(std::abs(difference) < last);
    last = std::abs(difference);
    const double k = std::cbrt(pressure * 0.1 / 1e3);
    CHECK(disc.middle_stretch - 1 == Approx(0.7 * 0.4311 * k * k).epsilon(2e-3));
  }
  const auto coarse = inflate_disc(law, 0.1, 1000, 50), middle = inflate_disc(law, 0.1, 1000, 100),
             fine = inflate_disc(law, 0.1, 1000, 200);
  CHECK((coarse.deflection - middle.deflection) / (middle.deflection - fine.deflection) ==
        Approx(4).epsilon(0.2));
  // Overall balance: the edge carries the pressure on the disc's area.
  const auto& x = fine.state.position;
  const Eigen::Vector2d span = x.segment<2>(2) - x.segment<2>(0);
  const auto t = membrane_tensions(law, fine.edge_stretch, (x[0] + x[2]) / (0.2 - 0.1 / 200));
  const double carried = 2 * pi * 0.1 * t.first * span[1] / span.norm();
  CHECK(carried == Approx(1000 * pi * 0.01).epsilon(0.01));  // an element
}

TEST_CASE("axisymmetric membrane: excessive loads are refused") {
  CHECK_THROWS_AS(inflate_disc(law, 0.1, 1e6, 50), ModelError);
  CHECK_THROWS_AS(inflate_disc(law, 0.1, 100, 2), ModelError);
}
