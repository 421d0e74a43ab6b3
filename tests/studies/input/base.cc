#include <catch2/catch.hpp>

#include "studies/run/resolved_study.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
using Catch::StartsWith;

namespace {

const char* const scene =
    "study = \"scene\"\n"
    "grid = {low = [\"0 m\", \"0 m\", \"0 m\"], high = [\"1 m\", \"1 m\", \"1 m\"], cell = \"0.1 "
    "m\"}\n"
    "time.end = \"1 ms\"\n"
    "[[body]]\nname = \"left\"\nshape = \"box\"\nlow = [\"0.1 m\", \"0.1 m\", \"0.1 m\"]\n"
    "high = [\"0.4 m\", \"0.4 m\", \"0.4 m\"]\ndensity = \"1000 kg/m^3\"\n"
    "youngs_modulus = \"1 MPa\"\npoisson_ratio = 0.3\n"
    "[[body]]\nname = \"right\"\nshape = \"sphere\"\ncenter = [\"0.7 m\", \"0.7 m\", \"0.7 m\"]\n"
    "radius = \"0.2 m\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"1 MPa\"\n"
    "poisson_ratio = 0.3\n";

/// The problems of a study that is based on `base.toml`.
std::string problems_over(const ScratchDirectory& scratch, const std::string& base,
                          const std::string& text, const std::vector<std::string>& overrides = {}) {
  scratch.write("base.toml", base);
  scratch.write("s.toml", text);
  return problems_in(scratch, "s.toml", overrides);
}

}  // namespace

TEST_CASE("a study overrides its base, --set overrides both") {
  const ScratchDirectory scratch;
  scratch.write("base.toml",
                "study = \"piercing\"\n[grid]\ncell = \"8 um\"\n[zona]\nlevel = 5\n"
                "density = \"1100 kg/m^3\"\n");
  const auto file = scratch.write("s.toml", "base = \"base.toml\"\n[grid]\ncell = \"7 um\"\n");
  const Configuration study = load_configuration(file, {"zona.level=6"});
  CHECK(study.kind() == "piercing");
  CHECK(study.quantity("grid.cell") == Approx(7e-6));
  CHECK(study.integer("zona.level") == 6);
  CHECK(study.quantity("zona.density") == Approx(1100));
  CHECK_THAT(si_table(study), Contains("base.toml:6: \"1100 kg/m^3\""));

  scratch.write("resolved.toml", resolved_study(study));
  const Configuration again = load_configuration(scratch.path() / "resolved.toml");
  CHECK(first_difference(study, again).empty());
}

TEST_CASE("a base may have a base, each with paths from its own directory") {
  const ScratchDirectory scratch;
  std::filesystem::create_directory(scratch.path() / "lab");
  scratch.write("lab/tip.csv", "time [us], displacement [um]\n0, 0\n100, 1\n200, 0\n");
  scratch.write("lab/trace.toml",
                "study = \"piercing\"\nmotion = {kind = \"trace\", trace = \"tip.csv\"}\n"
                "grid.cell = \"9 um\"\n");
  scratch.write("middle.toml", "base = \"lab/trace.toml\"\ngrid.cell = \"8 um\"\n");
  const auto file = scratch.write("s.toml", "base = \"middle.toml\"\nzona.level = 5\n");
  const Configuration study = load_configuration(file);
  CHECK(study.path("motion.trace") == scratch.path() / "lab/tip.csv");
  CHECK(study.quantity("grid.cell") == Approx(8e-6));
}

TEST_CASE("tables of a list are amended by name, or replaced as a whole") {
  const ScratchDirectory scratch;
  scratch.write("base.toml", scene);
  const auto load = [&](const std::string& text) {
    return load_configuration(scratch.write("s.toml", "base = \"base.toml\"\n" + text));
  };
  const Configuration amended = load("[body.right]\nradius = \"0.1 m\"\n");
  CHECK(amended.item_names("body") == std::vector<std::string>{"left", "right"});
  CHECK(amended.items("body")[1].quantity("radius") == Approx(0.1));
  CHECK(load("body.0.density = \"900 kg/m^3\"").items("body")[0].formula("density").constant());

  const Configuration replaced = load(
      "[[body]]\nname = \"only\"\nshape = \"sphere\"\ncenter = [\"0.5 m\", \"0.5 m\", \"0.5 m\"]\n"
      "radius = \"0.2 m\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"1 MPa\"\n"
      "poisson_ratio = 0.3\n");
  CHECK(replaced.item_names("body") == std::vector<std::string>{"only"});
  CHECK_THAT(problems_over(scratch, scene, "base = \"base.toml\"\nbody = []\n"),
             Contains("body: is missing; needs at least 1"));
  CHECK_THAT(
      problems_over(scratch, scene, "base = \"base.toml\"\n[body.rihgt]\nradius = \"1 m\"\n"),
      Contains("s.toml:3: body.rihgt.radius: there is no body"));
  CHECK_THAT(problems_over(scratch, scene,
                           "base = \"base.toml\"\nbody.right.radius = \"0.1 m\"\n"
                           "body.1.radius = \"0.2 m\"\n"),
             Contains("set twice"));
}

TEST_CASE("keys of a base that do not apply to the study are left out") {
  const ScratchDirectory scratch;
  const std::string changed =
      "base = \"base.toml\"\n[body.right]\nshape = \"box\"\nlow = [\"0.6 m\", \"0.6 m\", \"0.6 "
      "m\"]\nhigh = [\"0.9 m\", \"0.9 m\", \"0.9 m\"]\n";
  CHECK(problems_over(scratch, scene, changed).empty());
  CHECK_THAT(problems_over(scratch, scene, changed + "radius = \"1 m\"\n"),
             Contains("applies only where"));
  const std::string piercing =
      "study = \"piercing\"\n[fill]\nfluid = \"water\"\n[motion]\nperiod = \"90 us\"\n";
  CHECK(problems_over(scratch, piercing, "base = \"base.toml\"\nstudy = \"comparison\"\n").empty());
  CHECK_THAT(problems_over(scratch, piercing + "knid = 1\n",
                           "base = \"base.toml\"\nstudy = \"comparison\"\n[grid]\ncel = 1\n"),
             StartsWith("s.toml:4: grid.cel: unknown key of a comparison study; did you mean "
                        "grid.cell?\nbase.toml:6: motion.knid: unknown key"));
}

TEST_CASE("a base that cannot be used is refused at its line") {
  const ScratchDirectory scratch;
  const std::string base = "study = \"piercing\"\n";
  const auto refused = [&](const std::string& line) {
    return problems_over(scratch, base, "study = \"piercing\"\n" + line);
  };
  CHECK_THAT(refused("base = \"bsae.toml\""), Contains("s.toml:2: base: there is no file"));
  CHECK_THAT(refused("base = 5"), Contains("s.toml:2: base: 5 is not the path of a study file"));
  CHECK_THAT(refused("base = \"\""), Contains("is not the path"));
  CHECK_THAT(refused("base = \".\""), Contains("there is no file"));
  CHECK_THAT(refused("base = \"s.toml\""), Contains("perhaps a file is based on itself"));
  CHECK_THAT(problems_over(scratch, "grid = [", "base = \"base.toml\""),
             Contains("base.toml:1: this is not TOML"));
  CHECK_THAT(problems_over(scratch, base, base, {"base=\"base.toml\""}),
             Contains("--set: base: belongs in a study file"));
}
