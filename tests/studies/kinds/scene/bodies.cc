#include <catch2/catch.hpp>
#include <cmath>

#include "studies/measures/point_values.h"
#include "tests/studies/kinds/scene/scene_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;

namespace {

double mass_of(const zona::mpm::Body& body) {
  double mass = 0;
  for (double m : body.points.mass) mass += m;
  return mass;
}

}  // namespace

TEST_CASE("initial states are fields of place") {
  const Run run(tube_scene(R"toml([time]
end = "1 ms"
[[body]]
name = "gas"
shape = "grid"
points_per_cell = [2, 1, 1]
material = "gas"
density = "1 + x"
pressure = "1000 + 500*sin(2*pi*x)"
velocity = ["0.1*x", "0", "0"]
[[profile]]
name = "start"
times = ["0 s"]
)toml"));
  const auto& profile = run.profiles;
  REQUIRE(profile.at("slice").size() == 40);
  CHECK(run.results["bodies"]["gas"]["mass"].get<double>() == Approx(1.5 * 0.025 * 0.025));
  for (std::size_t i = 0; i < 40; ++i) {
    const double x = profile.at("slice")[i];
    CHECK(x == Approx((i + 0.5) * 0.025));
    CHECK(profile.at("points")[i] == 2);
    CHECK(profile.at("density")[i] == Approx(1 + x));  // linear: exact for the mean by volume
    const auto pressure = [](double at) { return 1000 + 500 * std::sin(2 * M_PI * at); };
    const double a = x - 0.00625, b = x + 0.00625;
    CHECK(profile.at("pressure")[i] == Approx((pressure(a) + pressure(b)) / 2));
    CHECK(profile.at("stress_xx")[i] == Approx(-profile.at("pressure")[i]));
    CHECK(profile.at("velocity_x")[i] ==
          Approx(0.1 * ((1 + a) * a + (1 + b) * b) / (2 + a + b)));  // the mean by mass
    // Ideal gas: the pressure is (gamma - 1) rho I.
    const double energy = (pressure(a) + pressure(b)) / (0.4 * (2 + a + b));
    CHECK(profile.at("energy")[i] == Approx(energy));
  }
}

TEST_CASE("probes name their point; profiles follow points that start in a slice or are in it") {
  const Run run(cube_scene(R"toml([[probe]]
name = "corner"
body = "cube"
place = ["0.2 m", "0.2 m", "0.41 m"]
quantities = ["position", "displacement", "velocity"]
[[probe]]
name = "began"
kind = "mean"
body = "cube"
high = ["0.3 m", "grid", "grid"]
quantities = ["position"]
[[probe]]
name = "is"
kind = "mean"
body = "cube"
membership = "current"
high = ["0.3 m", "grid", "grid"]
quantities = ["position"]
[[profile]]
name = "began"
width = "0.05 m"
times = ["0 s", "20 ms"]
[[profile]]
name = "is"
width = "0.05 m"
membership = "current"
times = ["20 ms"]
)toml"));
  const Run thrown(
      cube_scene("[[probe]]\nname = \"is\"\nkind = \"mean\"\nbody = \"cube\"\n"
                 "membership = \"current\"\nhigh = [\"0.2 m\", \"grid\", \"grid\"]\n"));
  const auto& corner = run.results["probes"]["corner"];
  CHECK(corner["start"][0].get<double>() == Approx(0.225));
  CHECK(corner["start"][2].get<double>() == Approx(0.375));
  CHECK(corner["distance"].get<double>() == Approx(std::sqrt(2 * 0.025 * 0.025 + 0.035 * 0.035)));
  CHECK(corner["position_x"]["final"].get<double>() == Approx(0.225));
  CHECK(run.results["probes"]["began"]["points"] == 32);
  CHECK(run.profiles.at("points").size() == 4 + 4 + 4);
  // A mean of no points has no value.
  CHECK(std::isnan(thrown.history.at("probe.is.displacement_x").back()));

  std::string moving = cube_scene(R"toml(velocity = ["5 m/s", "0", "0"]
[[profile]]
name = "began"
width = "0.1 m"
[[profile]]
name = "is"
width = "0.1 m"
membership = "current"
)toml");
  const Run moved(moving);
  const auto& slices = moved.profiles.at("slice");
  REQUIRE(slices.size() == 4);  // 2 that began there, 2 a cell further
  CHECK(slices[0] == Approx(0.25));
  CHECK(slices[2] == Approx(0.35));
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(moved.profiles.at("displacement_x")[i] == Approx(0.1));
    CHECK(moved.profiles.at("position_x")[i] == Approx(0.35 + 0.1 * (i % 2)));
    CHECK(moved.profiles.at("time")[i] == Approx(0.02));
  }
}

TEST_CASE("shapes have their volumes; a body outside of them fills the rest") {
  const auto scene = scene_case(R"toml([grid]
high = ["1 m", "1 m", "1 m"]
cell = "50 mm"
[time]
end = "1 ms"
[[body]]
name = "ball"
shape = "sphere"
center = ["0.25 m", "0.25 m", "0.25 m"]
radius = "0.2 m"
points_per_cell = 4
density = "1 kg/m^3"
youngs_modulus = "1 Pa"
poisson_ratio = 0.0
[[body]]
name = "rod"
shape = "cylinder"
from = ["0.6 m", "0.2 m", "0.2 m"]
to = ["0.6 m", "0.8 m", "0.8 m"]
radius = "0.1 m"
points = [3, 12, 20]
density = "1 kg/m^3"
youngs_modulus = "1 Pa"
poisson_ratio = 0.0
[[body]]
name = "pipe"
shape = "tube"
from = ["0.1 m", "0.8 m", "0.5 m"]
to = ["0.1 m", "0.8 m", "0.9 m"]
inner_radius = "40 mm"
outer_radius = "80 mm"
points = [2, 16, 10]
material = "rigid"
density = "1 kg/m^3"
[[body]]
name = "bubble"
shape = "icosphere"
center = ["0.3 m", "0.3 m", "0.75 m"]
radius = "0.1 m"
material = "membrane"
thickness = "1 mm"
density = "1000 kg/m^3"
youngs_modulus = "1 Pa"
poisson_ratio = 0.0
[[body]]
name = "box"
low = ["0.8 m", "grid", "grid"]
points_per_cell = 1
density = "1 kg/m^3"
youngs_modulus = "1 Pa"
poisson_ratio = 0.0
[[body]]
name = "air"
shape = "grid"
outside = ["ball", "rod", "pipe", "bubble", "box"]
points_per_cell = 4
material = "gas"
density = "1 kg/m^3"
pressure = "1 Pa"
)toml");
  const auto mass = [&](int b) { return mass_of(scene.model.bodies[b]); };
  const double ball = 4.0 / 3 * M_PI * 0.008, rod = M_PI * 0.01 * std::sqrt(0.72);
  const double pipe = M_PI * (0.0064 - 0.0016) * 0.4, bubble = 4.0 / 3 * M_PI * 0.001;
  // By cells a surface is cut in steps of 12.5 mm; by count the volume is exact.
  CHECK(mass(0) == Approx(ball).epsilon(0.02));
  CHECK(mass(1) == Approx(rod));
  CHECK(mass(2) == Approx(pipe));
  // "auto" is level 4, 2562 points: the inscribed polyhedron lacks 0.3 % of the sphere's area.
  CHECK(scene.model.bodies[3].points.size() == 2562);
  CHECK(mass(3) == Approx(4 * M_PI * 0.01).epsilon(0.004));
  CHECK(mass(4) == Approx(0.2));
  CHECK(mass(5) == Approx(1 - 0.2 - ball - rod - pipe - bubble).epsilon(0.01));
  CHECK_THAT(scene_cost(scene).text,
             Contains("grid of 20 x 20 x 20 cells") && Contains("pipe: 320 points"));
}

TEST_CASE("means of points are weighted by mass or by volume") {
  PointValues a, b;
  a.mass = 1;
  a.volume = 1;
  b.mass = 3;
  b.volume = 1;
  const std::size_t velocity = point_quantity("velocity").first;
  const std::size_t density = point_quantity("density").first;
  a.value[velocity] = 4;
  a.value[density] = 1;
  b.value[density] = 3;
  PointMean mean;
  CHECK(std::isnan(mean.mean().value[velocity]));
  mean.add(a);
  mean.add(b);
  CHECK(mean.mean().value[velocity] == 1);
  CHECK(mean.mean().value[density] == 2);
  CHECK(mean.points() == 2);
}
