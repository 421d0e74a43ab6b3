#include <catch2/catch.hpp>
#include <cmath>

#include "tests/studies/kinds/scene/scene_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;

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

TEST_CASE("held nodes carry a weight and report their work") {
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

TEST_CASE("a rigid body follows its formula, with the slope as its velocity") {
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
