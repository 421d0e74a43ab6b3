#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

std::string problems(const std::string& rest) {
  return problems_of("study = \"material_point\"\n" + rest);
}

/// Results of a bundled study.
nlohmann::json results_of(const std::string& name, const std::string& settings = "") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  const Answer answer = call("run " ZONA_SOURCE_DIR "/studies/" + name + ".toml --quiet --out " +
                             out.string() + " " + settings);
  INFO(answer.text);
  REQUIRE(answer.code == 0);
  return nlohmann::json::parse(read_text(out / "summary.json"))["results"];
}

}  // namespace

TEST_CASE("material_point: a solid yields, peaks and loses its strength") {
  const auto r = results_of("point_uniaxial");
  CHECK(r["yield"]["equivalent_stress"].get<double>() == Approx(300e6).epsilon(1e-3));
  CHECK(r["peak"]["equivalent_stress"].get<double>() == Approx(350e6).epsilon(1e-3));
  CHECK(r["bifurcation"].is_null());
  CHECK(r["failure"].is_null());
  CHECK(std::abs(r["end"]["stress"][0].get<double>()) < 1);
  // Rounding of 350 MPa.
  CHECK(r["largest_stress_of_free_components"].get<double>() < 1e-5);
  // The strength over the plastic path length, times sqrt(2/3); the trapezoids of the path differ
  // by some 1e-4.
  const double hardening = 0.5 * (300e6 + 350e6) * 50e6 / 10e9, fall = 0.5 * 350e6 * 350e6 / 5e9;
  CHECK(r["dissipated"].get<double>() ==
        Approx(std::sqrt(2.0 / 3) * (hardening + fall)).epsilon(1e-3));
}

TEST_CASE(
    "material_point: modes I, II and mixed dissipate u0 tau0/2 where the cell resolves them") {
  for (const char* name : {"point_mode_1", "point_mode_2", "point_mode_mixed"}) {
    const auto r = results_of(name);
    INFO(name);
    const auto& b = r["bifurcation"];
    CHECK_FALSE(b["failed_in_the_same_step"].get<bool>());
    CHECK(b["angle_to_largest_principal_stress"].get<double>() ==
          Approx(std::atan(std::sqrt(0.5))).epsilon(1e-3));
    CHECK_FALSE(r["failure"].is_null());
    const double resolved = r["resolved_opening_energy"];
    CHECK(resolved == Approx(0.5 * 1e-8 * b["reference_traction"].get<double>()).epsilon(1e-9));
    // First order in the step, 1 %.
    CHECK(r["opening_dissipation"].get<double>() == Approx(resolved).epsilon(0.02));
  }
  // Mode II slides and keeps the area, xx : yy = 1 : -1; besides, the elastic strain is gone.
  const auto r = results_of("point_mode_2");
  const auto &end = r["failure"]["strain"], &start = r["bifurcation"]["strain"];
  const double elastic = 1062.8 / 17.9e3;
  const double xx = end[0].get<double>() - start[0].get<double>() + elastic;
  const double yy = end[1].get<double>() - start[1].get<double>() - 0.49 * elastic;
  CHECK(yy / xx == Approx(-1).epsilon(0.05));
}

TEST_CASE("material_point: the zona fails at once in a cell of 6 um, and at 0.06 with damage") {
  const auto decohesion = results_of("point_zona");
  CHECK(decohesion["bifurcation"]["failed_in_the_same_step"].get<bool>());
  CHECK(decohesion["opening_dissipation"].get<double>() >
        30 * decohesion["resolved_opening_energy"].get<double>());
  CHECK(decohesion["failure"]["strain"][0].get<double>() == Approx(0.0598).epsilon(2e-3));
  const auto damage = results_of("point_elastodamage");
  CHECK(damage["failure"]["strain"][0].get<double>() == Approx(0.05999).epsilon(1e-3));
  CHECK(damage["yield"]["strain"][0].get<double>() == Approx(0.05937).epsilon(1e-3));
}

TEST_CASE("material_point: the history holds the components of the geometry") {
  const ScratchDirectory scratch;
  const auto first_line = [&](const std::string& name, const std::string& text) {
    const fs::path out = scratch.path() / name;
    REQUIRE(call("run " + scratch.write(name + ".toml", text).string() + " --quiet --out " +
                 out.string())
                .code == 0);
    std::istringstream history(read_text(out / "history.csv"));
    std::string line, last;
    std::getline(history, line);
    int rows = 0;
    for (; std::getline(history, last); ++rows) continue;
    CHECK(rows == 21);
    return line;
  };
  const std::string path = "path.xx = [0.01, 0]\npath.steps = 10\n";
  CHECK_THAT(first_line("solid", "study = \"material_point\"\n" + path),
             Contains("step,strain_xx,") && Contains("stress_zx [Pa]"));
  const std::string membrane = first_line(
      "membrane", "study = \"material_point\"\nmaterial.geometry = \"membrane\"\n" + path);
  CHECK_THAT(membrane, Contains("stress_xy [Pa]") && !Contains("zx"));
}

TEST_CASE("material_point: total and incremental stress agree along a path") {
  const ScratchDirectory scratch;
  const auto history = [&](const std::string& update) {
    const auto file = scratch.write(
        update + ".toml",
        "study = \"material_point\"\n[material]\ngeometry = \"membrane\"\nstress_update = \"" +
            update + "\"\n[path]\nxx = [0.03, -0.02, 0.01]\nyy = [0.01, 0.02]\nxy = [0.01]\n");
    const fs::path out = scratch.path() / update;
    REQUIRE(call("run " + file.string() + " --quiet --out " + out.string()).code == 0);
    return nlohmann::json::parse(read_text(out / "summary.json"))["results"]["end"]["stress"];
  };
  const auto total = history("total"), increments = history("increments");
  for (int c = 0; c < 6; ++c) {
    CHECK(total[c].get<double>() == Approx(increments[c].get<double>()).margin(1e-9));
  }
}

TEST_CASE("material_point: invalid input is reported") {
  CHECK(problems("").empty());
  CHECK_THAT(problems("material.law = \"von_mise\""), Contains("did you mean \"von_mises\"?"));
  CHECK_THAT(problems("material.geometry = \"shell\""), Contains("one of solid or membrane"));
  CHECK_THAT(problems("material.youngs_modulus = 3"), Contains("3 has no unit"));
  CHECK_THAT(problems("material.poisson_ratio = 0.5"), Contains("below 0.5"));
  CHECK_THAT(problems("material.yield_strength = \"0 Pa\""), Contains("out of range"));
  CHECK_THAT(problems("material.peak_strength = \"1000 Pa\""),
             Contains("1000 Pa is below the yield strength of 1062.8 Pa"));
  CHECK_THAT(problems("material.hardening_modulus = \"0 Pa\""), Contains("never rises"));
  CHECK_THAT(problems("material.softening_modulus = \"-1 Pa\""), Contains("at least 0 Pa"));
  CHECK(
      problems("material.peak_strength = \"auto\"\nmaterial.hardening_modulus = \"0 Pa\"").empty());
  CHECK_THAT(problems("material.reference_opening = \"0 m\""), Contains("above 0 m"));
  CHECK_THAT(problems("material.decohesion_exponent = 0.5"), Contains("at least 1"));
  CHECK_THAT(problems("material.mode_ratio = 0"), Contains("out of range"));
  CHECK_THAT(problems("material.reference_traction = \"0 Pa\""), Contains("above 0 Pa"));
  CHECK_THAT(problems("material.bifurcation = \"3d\""), Contains("plane_stress or source"));
  CHECK_THAT(problems("material.one_way = \"on\""), Contains("one of stress, strain or off"));
  CHECK_THAT(problems("material.cell = \"6\""), Contains("has no unit"));
  CHECK_THAT(problems("material.stress_update = \"increments\""), Contains("elastic membrane"));
  CHECK(problems("material.stress_update = \"increments\"\nmaterial.geometry = \"membrane\"")
            .empty());
  CHECK_THAT(problems("material.c0 = -1\nmaterial.c1 = -1\nmaterial.elastic_limit = 0"),
             Contains("c0") && Contains("c1") && Contains("elastic_limit"));
  CHECK_THAT(problems("path.xx = []"), Contains("the list is empty"));
  CHECK_THAT(problems("path.xx = 0.1"), Contains("needs a list"));
  CHECK_THAT(problems("path.yy = [-1]"), Contains("above -1"));
  CHECK_THAT(problems("path.xx = [\"0.1\"]"), Contains("needs a list, each a number"));
  CHECK_THAT(problems("path.free = [\"xz\"]"), Contains("one of xx, yy, zz, xy, yz or zx"));
  CHECK(problems("path.free = []").empty());
  CHECK_THAT(problems("path.free = [\"yy\"]\npath.yy = [0.1]"), Contains("is given although"));
  CHECK_THAT(problems("path.steps = 0"), Contains("at least 1"));
  const std::string membrane = "material.geometry = \"membrane\"\n";
  CHECK_THAT(problems(membrane + "path.zz = [0.1]"), Contains("no component zz"));
  CHECK_THAT(problems(membrane + "path.free = [\"yz\"]"), Contains("no component yz"));
  CHECK_THAT(problems(membrane + "path.xy = [1.5]"), Contains("inside out"));
}

TEST_CASE("zona.law: the keys of decohesion are checked in piercings as well") {
  const auto piercing = [](const std::string& rest) {
    return problems_of("study = \"piercing\"\n" + rest);
  };
  CHECK(piercing("zona.law = \"decohesion\"").empty());
  CHECK_THAT(piercing("zona.law = \"decohesio\""), Contains("did you mean \"decohesion\"?"));
  CHECK_THAT(piercing("zona.peak_strength = \"1 Pa\""), Contains("below the yield strength"));
  CHECK_THAT(piercing("zona.stress_update = \"increments\""), Contains("needs \"total\""));
  CHECK(piercing("zona.stress_update = \"increments\"\nzona.law = \"elastic\"").empty());
  CHECK_THAT(piercing("zona.mode_ratio = -10"), Contains("out of range"));
}
