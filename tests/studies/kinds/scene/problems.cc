#include <catch2/catch.hpp>

#include "studies/kinds/study_kinds.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
using Catch::Equals;

namespace {

const std::string frame = R"(study = "scene"
[grid]
high = ["1 m", "1 m", "1 m"]
cell = "0.1 m"
[time]
end = "1 ms"
)";

const std::string cube = R"([[body]]
name = "cube"
low = ["0.2 m", "0.2 m", "0.2 m"]
high = ["0.5 m", "0.5 m", "0.5 m"]
density = "1000 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
)";

/// What `zona check` would say: of the schema, and if it has nothing to say, of the model.
std::string problems(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", text);
  try {
    const Configuration study = load_configuration(file, overrides);
    find_study_kind("scene").prepare(study);
    return "";
  } catch (const InputError& error) {
    std::string message;
    for (const Problem& problem : error.problems()) {
      message += (message.empty() ? "" : "\n") + std::to_string(problem.line) + ": " + problem.key +
                 ": " + problem.message;
    }
    return message;
  }
}

std::string with(const std::string& override) {
  return problems(frame + cube, {override});
}

}  // namespace

TEST_CASE("a scene needs a grid, an end and a body") {
  CHECK(problems(frame + cube).empty());
  const std::string nothing = problems("study = \"scene\"\n");
  CHECK_THAT(nothing, Contains("grid.high: is missing") && Contains("grid.cell: is missing") &&
                          Contains("time.end: is missing") &&
                          Contains("body: is missing; needs at least 1; write [[body]]"));
}

TEST_CASE("a grid is a whole number of cells") {
  CHECK_THAT(with("grid.cell=\"0.3 m\""),
             Contains("the grid is 1 m along x, 3.33333 cells of 0.3 m; needs a whole number, e.g. "
                      "cells of 0.333333 m"));
  CHECK_THAT(with("grid.high=[\"1 m\", \"0 m\", \"1 m\"]"),
             Contains("y = 0 m is not above grid.low, 0 m"));
  CHECK_THAT(with("grid.cell=\"1 mm\""), Contains("1e+09 cells; at most 5e7"));
  CHECK(with("grid.cell=[\"0.1 m\", \"0.05 m\", \"0.2 m\"]").empty());
}

TEST_CASE("shapes and materials must be compatible") {
  CHECK_THAT(with("body.cube.shape=\"sphere\""),
             Contains("9: body.cube.low: applies only where shape = \"box\"; remove it") &&
                 Contains("body.cube.center: is missing"));
  const std::string sheet = R"([[body]]
name = "sheet"
shape = "sheet"
corner = ["0.2 m", "0.2 m", "0.5 m"]
edge_u = ["0.5 m", "0 m", "0 m"]
edge_v = ["0 m", "0.5 m", "0 m"]
density = "1000 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
)";
  CHECK_THAT(problems(frame + sheet),
             Contains("a sheet is a surface; needs material = \"membrane\""));
  const std::string membrane = sheet + "material = \"membrane\"\nthickness = \"1 mm\"\n";
  CHECK(problems(frame + membrane).empty());
  CHECK_THAT(problems(frame + membrane, {"body.sheet.edge_v=[\"1 m\", \"0 m\", \"0 m\"]"}),
             Contains("runs along edge_u"));
  CHECK_THAT(problems(frame + membrane, {"body.sheet.density=\"1000 + x\""}),
             Contains("body.sheet.density: a membrane or rigid body has one density"));
  CHECK_THAT(problems(frame + cube + "material = \"membrane\"\nthickness = \"1 mm\"\n"),
             Contains("a membrane is a surface, a box is not"));
  CHECK_THAT(with("body.cube.law=\"von_mises\""), Contains("body.cube.yield_strength: is missing"));
}

TEST_CASE("bodies hold points, all of them in the grid") {
  CHECK_THAT(with("body.cube.high=[\"0.2 m\", \"0.5 m\", \"0.5 m\"]"),
             Contains("x = 0.2 m is not above low, 0.2 m"));
  CHECK_THAT(with("body.cube.high=[\"0.201 m\", \"0.5 m\", \"0.5 m\"]"),
             Equals("7: body.cube.shape: holds no point; make it larger, the cells smaller, or "
                    "points_per_cell greater"));
  const std::string outside = problems(frame + cube + "points = [3, 3, 3]\n",
                                       {"body.cube.high=[\"2 m\", \"0.5 m\", \"0.5 m\"]"});
  CHECK_THAT(outside, Contains("body.cube.shape: a point at (1.1, 0.25, 0.25) m lies outside") ||
                          Contains("lies outside the grid"));
  CHECK_THAT(with("body.cube.outside=[\"cub\"]"),
             Contains("there is no body \"cub\"; did you mean"));
  CHECK_THAT(problems(frame + cube, {"body.cube.points_per_cell=100", "grid.cell=\"0.01 m\""}),
             Contains("a full grid would have 1e+12 points; at most 2e9"));
}

TEST_CASE("formulas are evaluated before a run") {
  CHECK_THAT(
      with("body.cube.velocity=[\"sqrt(x - 0.3)\", \"0\", \"0\"]"),
      Contains("body.cube.velocity: \"sqrt(x - 0.3)\" is") && Contains("nan m/s at x = 0.2"));
  CHECK_THAT(with("body.cube.density=\"1000*(x - 0.3)\""),
             Contains("kg/m^3 at x = 0.225") && Contains("needs above 0 kg/m^3"));
  CHECK_THAT(with("body.cube.velocity=[\"t\", \"0\", \"0\"]"), Contains("neither a quantity"));
  const std::string plate =
      "[[body]]\nname = \"plate\"\nhigh = [\"0.1 m\", \"grid\", \"grid\"]\nmaterial = \"rigid\"\n"
      "density = \"1 kg/m^3\"\n";
  CHECK_THAT(problems(frame + cube + plate, {"body.plate.displacement=[\"1 mm\", \"0\", \"0\"]"}),
             Contains("starts with (0.001, 0, 0) m; it must be zero at t = 0"));
  CHECK_THAT(problems(frame + cube + plate, {"body.plate.displacement=[\"log(t)\", \"0\", \"0\"]"}),
             Contains("is -inf m at t = 0"));
  CHECK(
      problems(frame + cube + plate, {"body.plate.displacement=[\"t^2\", \"0\", \"0\"]"}).empty());
  const std::string gas =
      "[[body]]\nname = \"gas\"\nshape = \"grid\"\noutside = [\"cube\"]\nmaterial = \"gas\"\n"
      "density = \"1 kg/m^3\"\n";
  CHECK_THAT(problems(frame + cube + gas), Contains("have no sound speed; needs more than"));
  CHECK(problems(frame + cube + gas + "pressure = \"1000 + x\"\n").empty());
}

TEST_CASE("holds and loads must contain nodes or points") {
  const std::string hold =
      "[[hold]]\nlow = [\"0.11 m\", \"grid\", \"grid\"]\nhigh = [\"0.12 m\", "
      "\"grid\", \"grid\"]\n";
  CHECK_THAT(problems(frame + cube + hold), Contains("15: hold.0.low:"));
  const std::string load =
      "[[load]]\nbody = \"cube\"\nhigh = [\"0.1 m\", \"grid\", \"grid\"]\n"
      "force = [\"1 N\", \"0\", \"0\"]\n";
  CHECK_THAT(problems(frame + cube + load), Contains("load.0.low:"));
  CHECK(problems(frame + cube + load, {"load.0.high=[\"1 m\", \"1 m\", \"1 m\"]"}).empty());
  CHECK_THAT(problems(frame + cube + load, {"load.0.kind=\"traction\""}),
             Contains("17: load.0.force: applies only where kind = \"force\"") &&
                 Contains("load.0.area: is missing"));
  const std::string pressure =
      "[[load]]\nbody = \"cube\"\nkind = \"pressure\"\npressure = \"1 Pa\"\n";
  CHECK_THAT(problems(frame + cube + pressure), Contains("cube is no membrane"));
}

TEST_CASE("quantities of probes and times of profiles are checked") {
  const std::string probe = "[[probe]]\nname = \"p\"\nbody = \"cube\"\nkind = \"mean\"\n";
  CHECK(problems(frame + cube + probe).empty());
  CHECK_THAT(problems(frame + cube + probe + "quantities = [\"strain\"]\n"),
             Contains("the points of cube (material solid, law elastic) have no strain"));
  CHECK_THAT(problems(frame + cube + probe + "quantities = [\"stres\"]\n"),
             Contains("did you mean \"stress\"?"));
  const std::string profile = "[[profile]]\nname = \"x\"\ntimes = [\"0.5 ms\", \"2 ms\"]\n";
  CHECK_THAT(problems(frame + cube + profile), Contains("0.002 s is after the end of the run"));
}

TEST_CASE("the step of a scene is checked") {
  // Waves of 36.7 m/s cross a cell in 2.7 ms, and in 0.27 us where the solid is 1e8 times as stiff.
  CHECK(with("time.step=\"0.9 ms\"").empty());
  CHECK_THAT(problems(frame + cube, {"time.step=\"1 us\"", "body.cube.youngs_modulus=\"1e14 Pa\""}),
             Contains("time.step: 1000 ns is above the critical step of 272.6 ns"));
  CHECK_THAT(with("time.step=\"2 ms\""), Contains("longer than the run"));
  const std::string still =
      "[[body]]\nname = \"plate\"\nshape = \"grid\"\nmaterial = \"rigid\"\n"
      "density = \"1 kg/m^3\"\n";
  CHECK_THAT(problems(frame + still), Contains("time.step: nothing limits the step"));
  CHECK(problems(frame + still, {"time.step=\"1 us\""}).empty());
}
