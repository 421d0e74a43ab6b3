#include <catch2/catch.hpp>

#include "studies/input/keys.h"
#include "studies/input/nearest.h"
#include "studies/kinds/study_kinds.h"
#include "studies/program/bundled_studies.h"
#include "studies/program/reference.h"
#include "studies/run/resolved_study.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;

namespace {

void check_round_trip(const Configuration& study) {
  const ScratchDirectory elsewhere;
  const Configuration again =
      load_configuration(elsewhere.write("study.toml", resolved_study(study)));
  CHECK(again.kind() == study.kind());
  REQUIRE(again.tables() == study.tables());
  for (const std::string& table : study.tables()) {
    REQUIRE(again.keys_of(table) == study.keys_of(table));
    for (const std::string& key : study.keys_of(table)) {
      INFO(key);
      CHECK(again.setting(key).numbers == study.setting(key).numbers);
      CHECK(again.setting(key).is_auto == study.setting(key).is_auto);
      CHECK_FALSE(again.is_default(key));
      if (study.schema().find(key)->kind == Parameter::Kind::file) {
        CHECK(again.path(key) == study.path(key));
      } else {
        CHECK(again.texts(key) == study.texts(key));
      }
    }
  }
}

}  // namespace

TEST_CASE("a resolved study loads to the same configuration") {
  for (const BundledStudy& study : bundled_studies()) {
    INFO(study.file.string());
    check_round_trip(load_configuration(study.file));
  }
  const ScratchDirectory scratch;
  scratch.write("tip \"1\".csv", "time,displacement\n0,0\n");
  const auto file = scratch.write("odd.toml",
                                  "study = \"piercing\"\nmotion.kind = \"trace\"\n"
                                  "motion.trace = 'tip \"1\".csv'\nzona.c0 = 0.1\nzona.c1 = 12\n"
                                  "motion.scale = 1e-17\ngrid.cell = \"6e0\\tum\"\n");
  check_round_trip(load_configuration(file, {"run.threads = 0x10"}));
}

TEST_CASE("a resolved study marks its defaults") {
  const Configuration study = load_configuration(ZONA_SOURCE_DIR "/studies/vibration.toml");
  const std::string text = resolved_study(study);
  CHECK_THAT(text, Contains("length = \"10 mm\"\n"));
  CHECK_THAT(text, Catch::Matches("[^]*rayleigh_beta = \"0 s\" +# default\n[^]*"));
  CHECK_THAT(si_table(study), Contains("6.344e+10 Pa"));
}

TEST_CASE("the parameter reference is up to date") {
  INFO("run: zona reference > docs/parameters.md");
  CHECK(read_text(ZONA_SOURCE_DIR "/docs/parameters.md") == parameter_reference());
}

TEST_CASE("every parameter is documented") {
  for (const StudyKind& kind : study_kinds()) {
    for (const Parameter& parameter : kind.schema->parameters()) {
      INFO(kind.schema->kind() << " " << parameter.key);
      CHECK(parameter.documentation.size() > 10);
      CHECK(parameter.documentation.back() == '.');
      for (const Condition& condition : parameter.conditions) {
        const std::string choice = table_of(parameter.key) + "." + condition.key;
        REQUIRE(kind.schema->find(choice) != nullptr);
        CHECK(kind.schema->find(choice)->kind == Parameter::Kind::choice);
        CHECK(kind.schema->find(choice) < &parameter);  // declared before
      }
      CHECK_FALSE(parameter.expectation().empty());
    }
  }
}

TEST_CASE("help finds keys, tables, kinds and near misses") {
  CHECK_THAT(parameter_help("grid.cell"), Contains("grid.cell = \"6 um\"\n"));
  CHECK_THAT(parameter_help("cell"), Contains("grid.cell = \"6 um\"\n"));
  CHECK_THAT(parameter_help("grid"), Contains("grid.domain"));
  CHECK_THAT(parameter_help("grid.do"), Contains("grid.domain"));
  CHECK_THAT(parameter_help("vibration"), Contains("[pulse]"));
  CHECK_THAT(parameter_help("pipette.length"), Contains("study: vibration"));
  CHECK_THROWS_WITH(parameter_help("gird.cell"), Contains("did you mean grid.cell?"));
  CHECK_THROWS_WITH(parameter_help("xyzzy"), Contains("lists the tables"));
}

TEST_CASE("edit distance") {
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("cell", "cell") == 0);
  CHECK(edit_distance("cel", "cell") == 1);
  CHECK(edit_distance("newmrak", "newmark") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(nearest_name("mesh.cell", {"grid.cell", "mesh.size"}) == "grid.cell");
  CHECK(nearest_name("pipette.lenght", {"beam.length", "pipette.length"}) == "pipette.length");
  CHECK(nearest_name("qqq", {"grid.cell"}).empty());
}

TEST_CASE("contradictory declarations are refused") {
  Schema schema("drop", "A drop falls.");
  schema.section("drop", "The drop.");
  CHECK_THROWS_AS(schema.quantity("drop.size", "m", "2 mm").in("(1, 0)"), std::logic_error);
  CHECK_THROWS_AS(schema.quantity("drop.size", "m", "2 mm"), std::logic_error);
  CHECK_THROWS_AS(schema.number("plate.size", 1), std::logic_error);
  CHECK_THROWS_AS(schema.number("drop.speed", 1).in("0..1"), std::logic_error);
}

TEST_CASE("a required key must be set") {
  Schema schema("drop", "A drop falls.");
  schema.section("drop", "The drop.");
  schema.quantity("drop.size", "m", "2 mm").without_default().in("(0, 1]").doc("Diameter.");
  const ScratchDirectory scratch;
  const auto file = scratch.write("drop.toml", "study = \"drop\"");
  CHECK_THROWS_WITH(load_configuration(file, {}, {&schema}),
                    Contains("drop.toml: drop.size: is missing; needs a length, above 0 m and at "
                             "most 1 m; write e.g. drop.size = \"6 um\""));
  CHECK(load_configuration(file, {"drop.size=\"3 mm\""}, {&schema}).quantity("drop.size") == 3e-3);
}
