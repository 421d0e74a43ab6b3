#include <catch2/catch.hpp>
#include <cmath>

#include "tests/studies/kinds/scene/scene_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

TEST_CASE("a scene falls freely and keeps its energy") {
  const Run run(
      cube_scene("[gravity]\nacceleration = [\"9.81 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n"
                 "[[probe]]\nname = \"mean\"\nkind = \"mean\"\nbody = \"cube\"\n"
                 "quantities = [\"displacement\", \"velocity\", \"equivalent_stress\"]\n"));
  const auto& t = run.history.at("time");
  REQUIRE(t.size() == 21);
  const double dt = 5e-4;
  for (std::size_t i = 0; i < t.size(); ++i) {
    CHECK(t[i] == Approx(i * 1e-3));
    CHECK(run.history.at("probe.mean.velocity_x")[i] == Approx(9.81 * t[i]).margin(1e-12));
    // Symplectic Euler: the fall is g t (t + dt) / 2, exactly.
    const double fall = 9.81 * t[i] * (t[i] + dt) / 2;
    CHECK(run.history.at("probe.mean.displacement_x")[i] == Approx(fall).margin(1e-12));
    CHECK(run.history.at("kinetic_energy")[i] ==
          Approx(4 * std::pow(9.81 * t[i], 2)).margin(1e-12));
    const double potential = run.history.at("potential_energy")[i];
    CHECK(potential - run.history.at("potential_energy")[0] ==
          Approx(-8 * 9.81 * fall).margin(1e-9));
  }
  CHECK(run.history.at("mass").back() == Approx(8));
  CHECK(run.history.at("momentum_x").back() == Approx(8 * 9.81 * 0.02));
  CHECK(run.results["probes"]["mean"]["points"] == 64);
  CHECK(run.results["probes"]["mean"]["velocity_x"]["highest"].get<double>() ==
        Approx(9.81 * 0.02));
  CHECK(run.results["bodies"]["cube"]["mass"].get<double>() == Approx(8));
  CHECK(run.results["steps"] == 40);
  CHECK_FALSE(fs::exists(run.out() / "fields.h5"));
  CHECK_FALSE(fs::exists(run.out() / "profiles.csv"));
}

TEST_CASE("an acoustic wave stands in a scene") {
  const std::string wave = R"toml([time]
end = "0.571 ms"
courant = 0.1
[[body]]
name = "water"
shape = "grid"
points_per_cell = [3, 1, 1]
material = "liquid"
density = "1000 kg/m^3"
velocity = ["0.01*sin(pi*x)", "0", "0"]
[[probe]]
name = "middle"
kind = "mean"
body = "water"
low = ["0.475 m", "grid", "grid"]
high = ["0.525 m", "grid", "grid"]
quantities = ["velocity", "pressure"]
)toml";
  for (const char* shape : {"linear", "quadratic"}) {
    std::string text = tube_scene(wave);
    text.replace(text.find("cell = "), 0, "interpolation = \"" + std::string(shape) + "\"\n");
    const Run run(text);
    const double w = M_PI * std::sqrt(5 * 6.13e8 / 1000);
    const auto& v = run.history.at("probe.middle.velocity_x");
    const auto& t = run.history.at("time");
    for (std::size_t i = 0; i < t.size(); ++i) {
      // Velocities stand half a step beside positions, w dt / 2 = 0.0039 of the amplitude; the mean
      // over the probe is 0.001 below the middle's; the rest is dispersion of 40 cells, greater for
      // quadratic splines that end at walls. All of it halves with the cells.
      CHECK(v[i] == Approx(0.01 * std::cos(w * t[i])).margin(0.01 * 0.01));
    }
  }
}

TEST_CASE("all outputs of a scene are the same to the last bit for one, two and three threads") {
  const std::string text = "study = \"scene\"\n" + cube_scene(R"toml(law = "von_mises"
yield_strength = "500 Pa"
velocity = ["3 m/s", "y", "0"]
[[body]]
name = "lid"
shape = "sheet"
corner = ["0.5 m", "0.1 m", "0.1 m"]
edge_u = ["0 m", "0.4 m", "0 m"]
edge_v = ["0 m", "0 m", "0.4 m"]
material = "membrane"
thickness = "5 mm"
density = "1000 kg/m^3"
youngs_modulus = "100 kPa"
poisson_ratio = 0.3
[[body]]
name = "air"
shape = "grid"
outside = ["cube"]
material = "gas"
density = "1 kg/m^3"
pressure = "1 kPa"
average_volume_strain = true
[[hold]]
high = ["0 m", "grid", "grid"]
[[load]]
body = "lid"
kind = "pressure"
pressure = "100*t"
[[probe]]
name = "lid"
kind = "mean"
body = "lid"
quantities = ["position", "velocity", "stress", "strain", "energy"]
[[profile]]
name = "x"
)toml");
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", text).string();
  std::vector<std::string> files[3];
  for (const int threads : {1, 2, 3}) {
    const fs::path out = scratch.path() / std::to_string(threads);
    const auto answer = call("run " + file + " --quiet --set output.fields=true --threads " +
                             std::to_string(threads) + " --out " + out.string() +
                             " --set 'boundary={x_low = \"roller\", x_high = \"roller\", y_low = "
                             "\"roller\", y_high = \"roller\", z_low = \"roller\", z_high = "
                             "\"roller\"}'");
    INFO(answer.text);
    REQUIRE(answer.code == 0);
    for (const char* name : {"history.csv", "profiles.csv", "fields.h5"}) {
      files[threads - 1].push_back(read_text(out / name));
      CHECK(files[threads - 1].back().size() > 1000);
    }
  }
  CHECK(files[0] == files[1]);
  CHECK(files[0] == files[2]);
}

TEST_CASE("a point that leaves the grid ends a scene and keeps the results") {
  const Run run(cube_scene("velocity = [\"100 m/s\", \"0\", \"0\"]\n"), "--set time.courant=0.5");
  CHECK(run.answer.code == 3);
  CHECK_THAT(run.answer.text, Contains("a point left the grid") && Contains("cube"));
  // The corner's points stand at 0.375 m: 0.625 m at 100 m/s are 12.5 steps.
  CHECK(run.results["steps"] == 12);
  CHECK(run.history.at("time").back() == Approx(6e-3));
}
