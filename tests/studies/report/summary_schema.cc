#include "tests/studies/kinds/search/search_files.h"

using namespace zona::studies::testing;
using Catch::Contains;

namespace {

const std::string studies = ZONA_SOURCE_DIR "/studies/";
const std::string small_egg =
    " --set 'grid.cell=\"12 um\"' --set 'grid.domain=\"168 um\"' --set zona.level=4"
    " --set zona.elastic_limit=0.002 --set cytoplasm.points_per_cell=1 --set output.fields=false";

/// Four of the fifty cases.
const std::string small_vibration =
    studies +
    "vibration.toml"
    " --set 'fill.fluids=[\"mercury\", \"none\"]' --set 'pulse.durations=[\"60 us\", \"300 us\"]'";

bool has_validator() {
  const bool found = run_command("/usr/bin/python3 -c 'import jsonschema'").code == 0;
  if (!found) WARN("python3-jsonschema is not there to validate with");
  return found;
}

/// Runs a study and validates its summary against the published schema.
void check_summary(const std::string& arguments, int code, const std::string& status) {
  const ScratchDirectory scratch;
  const auto out = scratch.path() / "out";
  const Answer run = call("run " + arguments + " --quiet --out " + out.string());
  INFO(run.text);
  CHECK(run.code == code);
  const std::string summary = (out / "summary.json").string();
  CHECK_THAT(read_text(summary), Contains("\"status\": \"" + status + "\""));
  const Answer valid = run_command("/usr/bin/python3 -W ignore -m jsonschema -i " + summary +
                                   " " ZONA_SOURCE_DIR "/studies/report/summary.schema.json");
  INFO(valid.text);
  CHECK(valid.code == 0);
}

}  // namespace

TEST_CASE("summary.json of every kind of study follows its published schema") {
  if (!has_validator()) return;
  const std::string piercing = studies + "piercing_lateral_quick.toml" + small_egg;
  SECTION("vibration") {
    check_summary(small_vibration + " --set output.history=false", 0, "complete");
  }
  SECTION("vibration and piercing after an oblique pulse") {
    const std::string oblique = " --set 'pulse.angle=\"45 deg\"'";
    check_summary(small_vibration + oblique, 0, "complete");
    check_summary(
        studies + "piercing_beam_quick.toml" + small_egg + oblique + " --set 'time.end=\"1 us\"'",
        0, "complete");
  }
  SECTION("piercing, with a probe") {
    const ScratchDirectory scratch;
    const auto file =
        scratch.write("s.toml", "base = \"" + studies +
                                    "piercing_lateral_quick.toml\"\n[[probe]]\nname = \"p\"\nbody "
                                    "= \"zona\"\nplace = [\"50 um\", \"0 m\", \"0 m\"]\n");
    check_summary(file.string() + small_egg + " --set 'time.end=\"1 us\"'", 0, "complete");
  }
  SECTION("piercing with decohesion") {
    check_summary(piercing + " --set 'time.end=\"2 us\"' --set 'zona.law=\"decohesion\"'", 0,
                  "complete");
  }
  SECTION("comparison") {
    check_summary(studies + "mercury_vs_water.toml" + small_egg +
                      " --set 'time.end=\"4 us\"' --set 'fill.fluids=[\"water\", \"none\"]'",
                  0, "complete");
  }
  SECTION("search") {
    const SearchFiles files(
        search_study + "[[uncertain]]\nkey = \"cytoplasm.points_per_cell\"\nvalues = [1, 8]\n");
    check_summary(files.file() +
                      " --set search.samples=4 --set search.evaluations=2"
                      " --set search.candidates=2 --set search.refinements=1",
                  0, "complete");
  }
  SECTION("scene") {
    check_summary(studies + "verification/hanging_bar.toml --set 'time.end=\"1 ms\"'", 0,
                  "complete");
  }
  SECTION("scene with held nodes") {
    check_summary(studies + "verification/stokes.toml --set 'profile=[]' --set 'time.end=\"1 ms\"'",
                  0, "complete");
  }
  SECTION("material points, with and without an opening") {
    check_summary(studies + "point_zona.toml", 0, "complete");
    check_summary(studies + "point_uniaxial.toml", 0, "complete");
  }
  SECTION("a failed run and its reason") {
    check_summary(piercing + " --set 'motion.amplitude=\"900 um\"' --set 'time.end=\"40 us\"'", 3,
                  "failed");
  }
}

TEST_CASE("the schema refuses undocumented keys") {
  if (!has_validator()) return;
  const ScratchDirectory scratch;
  const auto out = scratch.path() / "out";
  REQUIRE(call("run " + small_vibration + " --quiet --out " + out.string()).code == 0);
  std::string text = read_text(out / "summary.json");
  text.replace(text.find("peak_velocity"), 13, "peek_velocity");
  const auto changed = scratch.write("changed.json", text);
  CHECK(run_command("/usr/bin/python3 -W ignore -m jsonschema -i " + changed.string() +
                    " " ZONA_SOURCE_DIR "/studies/report/summary.schema.json")
            .code == 1);
}
