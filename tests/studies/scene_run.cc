#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/point_values.h"
#include "studies/scene_case.h"
#include "tests/studies/call.h"
#include "tests/studies/csv.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A scene that was run, with what it wrote.
class Run {
 public:
  explicit Run(const std::string& text, const std::string& arguments = "") {
    const auto file = scratch_.write("s.toml", "study = \"scene\"\n" + text);
    answer = call("run " + file.string() + " --quiet --threads 2 --out " + out().string() + " " +
                  arguments);
    INFO(answer.text);
    if (arguments.empty()) REQUIRE(answer.code == 0);
    if (fs::exists(out() / "history.csv")) history = read_columns(out() / "history.csv");
    if (fs::exists(out() / "profiles.csv")) profiles = read_columns(out() / "profiles.csv");
    results = nlohmann::json::parse(read_text(out() / "summary.json"))["results"];
  }

  fs::path out() const { return scratch_.path() / "out"; }

  Answer answer;
  std::map<std::string, std::vector<double>> history, profiles;
  nlohmann::json results;

 private:
  ScratchDirectory scratch_;
};

/// 10 x 6 x 6 cells of 0.1 m with a cube of 8 kg in the middle.
std::string cube_scene(const std::string& rest) {
  return R"toml([grid]
high = ["1 m", "0.6 m", "0.6 m"]
cell = "0.1 m"
[time]
end = "20 ms"
step = "0.5 ms"
[output]
fields = false
history_interval = "1 ms"
[[body]]
name = "cube"
low = ["0.2 m", "0.2 m", "0.2 m"]
high = ["0.4 m", "0.4 m", "0.4 m"]
density = "1000 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
)toml" + rest;
}

/// A tube of 40 cells along x, 1 m long, closed on all sides.
std::string tube_scene(const std::string& rest) {
  return R"toml([grid]
high = ["1 m", "25 mm", "25 mm"]
cell = "25 mm"
[boundary]
x_low = "roller"
x_high = "roller"
y_low = "roller"
y_high = "roller"
z_low = "roller"
z_high = "roller"
[output]
fields = false
)toml" + rest;
}

SceneCase scene_case(const std::string& text) {
  const ScratchDirectory scratch;
  return make_scene_case(load_configuration(scratch.write("s.toml", "study = \"scene\"\n" + text)));
}

double mass_of(const zona::mpm::Body& body) {
  double mass = 0;
  for (double m : body.points.mass) mass += m;
  return mass;
}

}  // namespace

TEST_CASE("a scene falls as it should and keeps its energy") {
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

TEST_CASE("forces, tractions and pressures of time give their impulse") {
  // Integral of the load over the steps: the scheme takes it at one instant of each step, so a load
  // that is linear in time is off by half a step of 40, at most 1 / 40 of the impulse.
  const Run force(cube_scene("[[load]]\nbody = \"cube\"\nforce = [\"1000*t\", \"-2 N\", \"0\"]\n"));
  CHECK(force.history.at("momentum_x").back() == Approx(0.2).epsilon(1.0 / 40 + 1e-9));
  CHECK(force.history.at("momentum_y").back() == Approx(-0.04));
  const Run traction(
      cube_scene("[[load]]\nbody = \"cube\"\nkind = \"traction\"\narea = \"40000 mm^2\"\n"
                 "low = [\"0.3 m\", \"grid\", \"grid\"]\n"
                 "traction = [\"50 Pa\", \"0\", \"0\"]\n"));
  CHECK(traction.history.at("momentum_x").back() == Approx(0.04 * 50 * 0.02));
  const Run pressure(cube_scene(R"toml([[body]]
name = "lid"
shape = "disc"
center = ["0.7 m", "0.3 m", "0.3 m"]
radius = "0.15 m"
normal = "x"
rings = 6
material = "membrane"
thickness = "10 mm"
density = "1000 kg/m^3"
youngs_modulus = "1 kPa"
poisson_ratio = 0.3
[[load]]
name = "gas"
body = "lid"
kind = "pressure"
pressure = "0.5 Pa"
)toml"));
  // The disc is a polygon of 36 edges: its area is that, not the circle's.
  const double area = 18 * std::sin(M_PI / 18) * 0.15 * 0.15;
  CHECK(pressure.results["bodies"]["lid"]["mass"].get<double>() == Approx(area * 10));
  CHECK(pressure.history.at("momentum_x").back() == Approx(0.5 * area * 0.02).epsilon(1e-4));
}

TEST_CASE("held nodes carry a weight, and their work is what they do") {
  const std::string gravity =
      "[gravity]\nacceleration = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n";
  const Run still(cube_scene(gravity + "[[hold]]\nname = \"all\"\n"));
  CHECK(still.history.at("hold.all.force_z").back() == Approx(8 * 9.81));
  CHECK(still.history.at("kinetic_energy").back() == Approx(0).margin(1e-12));
  // Everything is moved: the momentum is the integral of the force, the energy the work. The
  // acceleration of the first step, from rest to V(dt), is the formula's as well.
  const Run moved(cube_scene("[[hold]]\nname = \"all\"\nvelocity = [\"2*t\", \"0\", \"0\"]\n"));
  CHECK(moved.history.at("momentum_x").back() == Approx(8 * 2 * 0.02));
  CHECK(moved.history.at("hold.all.force_x").back() == Approx(8 * 2));
  // The force times the velocity at the end of each step: half a step of 40 too late.
  CHECK(moved.history.at("hold.all.work").back() ==
        Approx(moved.history.at("kinetic_energy").back()).epsilon(1.0 / 40 + 1e-9));
  const Run sliding(cube_scene(gravity + "[[hold]]\naxes = [\"z\"]\n[[load]]\nbody = \"cube\"\n"
                                         "force = [\"8 N\", \"0\", \"0\"]\n"));
  CHECK(sliding.history.at("momentum_x").back() == Approx(8 * 0.02));
  CHECK(sliding.history.at("hold.0.force_z").back() == Approx(8 * 9.81));
}

TEST_CASE("a rigid body moves as its formula says, its velocity is the slope") {
  const auto scene = scene_case(cube_scene(R"toml([[body]]
name = "plate"
high = ["0.1 m", "grid", "grid"]
material = "rigid"
density = "1 kg/m^3"
displacement = ["1e-3*sin(300*t)", "t < 10e-3 ? 0.1*t : 1e-3", "t^2"]
)toml"));
  const auto* plate = scene.model.bodies[1].prescribed();
  REQUIRE(plate != nullptr);
  for (double t : {0.0, 1e-3, 7e-3, 15e-3, 20e-3}) {
    const auto state = plate->state(t);
    CHECK(state.displacement.x() == Approx(1e-3 * std::sin(300 * t)));
    // Fourth-order differences over a tenth of a step of 0.5 ms; at the start, over the first
    // fifth.
    const double at = std::max(t, 1e-4);
    CHECK(state.velocity.x() == Approx(0.3 * std::cos(300 * at)).epsilon(1e-6));
    CHECK(state.velocity.y() == Approx(t < 10e-3 ? 0.1 : 0).margin(1e-9));
    CHECK(state.velocity.z() == Approx(2 * at).epsilon(1e-9));
  }
}

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

TEST_CASE("probes name their point, profiles tell points that began in a slice from those in it") {
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

TEST_CASE("shapes have their volumes, and what is outside fills the rest") {
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
  // "auto" is level 3, 642 points: the inscribed polyhedron lacks 1.1 % of the sphere's area.
  CHECK(scene.model.bodies[3].points.size() == 642);
  CHECK(mass(3) == Approx(4 * M_PI * 0.01).epsilon(0.012));
  CHECK(mass(4) == Approx(0.2));
  CHECK(mass(5) == Approx(1 - 0.2 - ball - rod - pipe - bubble).epsilon(0.01));
  CHECK_THAT(scene_cost(scene),
             Contains("grid of 20 x 20 x 20 cells") && Contains("pipe: 320 points"));
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

TEST_CASE("a point that leaves the grid ends a scene with what was computed") {
  const Run run(cube_scene("velocity = [\"100 m/s\", \"0\", \"0\"]\n"), "--set time.courant=0.5");
  CHECK(run.answer.code == 3);
  CHECK_THAT(run.answer.text, Contains("a point left the grid") && Contains("cube"));
  // The corner's points stand at 0.375 m: 0.625 m at 100 m/s are 12.5 steps.
  CHECK(run.results["steps"] == 12);
  CHECK(run.history.at("time").back() == Approx(6e-3));
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
