#include <catch2/catch.hpp>

#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
using Catch::Equals;

namespace {

std::string piercing(const std::string& rest, const std::vector<std::string>& overrides = {}) {
  return problems_of("study = \"piercing\"\n" + rest, overrides);
}

}  // namespace

TEST_CASE("a file with defaults alone is valid") {
  CHECK(piercing("").empty());
  CHECK(piercing("[grid]\n").empty());
  CHECK(problems_of("study = \"vibration\"").empty());
  CHECK(problems_of("study = \"comparison\"").empty());
  CHECK(problems_of("study = \"material_point\"").empty());
}

TEST_CASE("a quantity needs the right unit") {
  CHECK_THAT(piercing("[grid]\ncell = 6\n"),
             Equals("s.toml:3: grid.cell: 6 has no unit; needs a unit of length, e.g. \"6 um\""));
  CHECK_THAT(piercing("[grid]\ncell = \"6\"\n"),
             Contains("s.toml:3: grid.cell: \"6\" has no unit"));
  CHECK_THAT(piercing("[grid]\ncell = \"6 s\"\n"), Contains("needs a unit of length"));
  CHECK_THAT(piercing("[grid]\ncell = true\n"), Contains("true is a boolean; needs a length"));
  CHECK_THAT(piercing("[grid]\ncell = \"auto\"\n"), Contains("is not a quantity"));
  CHECK(piercing("[time]\nend = \"auto\"\n").empty());
}

TEST_CASE("values must be in range") {
  CHECK_THAT(piercing("[grid]\ncell = \"0 um\"\n"),
             Contains("\"0 um\" is out of range; needs a length, at least 1e-09 m and at most "
                      "0.001 m"));
  CHECK_THAT(piercing("zona.poisson_ratio = 0.5"), Contains("above -1 and below 0.5"));
  CHECK_THAT(piercing("zona.poisson_ratio = nan"), Contains("nan is not finite"));
  CHECK_THAT(piercing("zona.c0 = 1e300"), Contains("out of range"));
  CHECK_THAT(piercing("zona.level = 9223372036854775807"), Contains("is not allowed"));
  CHECK_THAT(piercing("zona.level = 6.0"), Contains("6.0 is a number; needs a whole number"));
  CHECK_THAT(piercing("cytoplasm.points_per_cell = 9"), Contains("one of 1, 8, 27 or 64"));
  CHECK_THAT(piercing("run.threads = -1"), Contains("at least 0"));
}

TEST_CASE("misspelt choices and names suggest the nearest") {
  CHECK_THAT(piercing("motion.kind = \"trase\""),
             Contains("one of sine, triangle, beam or trace; did you mean \"trace\"?"));
  CHECK_THAT(piercing("fill.fluid = \"watr\""), Contains("did you mean \"water\"?"));
  CHECK_THAT(piercing("fill.fluid = 1000"), Contains("has no unit"));
  CHECK(piercing("fill.fluid = \"2500 kg/m^3\"").empty());
}

TEST_CASE("unknown keys suggest the nearest") {
  CHECK_THAT(
      piercing("[grid]\ncel = \"6 um\""),
      Equals("s.toml:3: grid.cel: unknown key of a piercing study; did you mean grid.cell?"));
  CHECK_THAT(piercing("cell = \"6 um\""), Contains("s.toml:2: cell: unknown key"));
  CHECK_THAT(piercing("cell = \"6 um\""), Contains("did you mean grid.cell?"));
  CHECK_THAT(piercing("[girds]\n"), Contains("did you mean grid?"));
  CHECK_THAT(piercing("[xyzzy]\nplugh = 1"),
             Contains("unknown key of a piercing study; remove it"));
  CHECK_THAT(piercing("\"grid.cell\" = \"6 um\""), Contains("unknown key"));
  CHECK_THAT(piercing("grid = 5"), Contains("is a table, not a value"));
  CHECK_THAT(piercing("[grid.cell]\nx = 1"), Contains("grid.cell is a value, not a table"));
  CHECK_THAT(piercing("[[grid]]\ncell = 1"), Contains("s.toml:2: grid: is a table"));
}

TEST_CASE("lists are checked item by item") {
  const auto vibration = [](const std::string& rest) {
    return problems_of("study = \"vibration\"\n" + rest);
  };
  CHECK_THAT(vibration("pulse.durations = []"), Contains("the list is empty"));
  CHECK_THAT(vibration("pulse.durations = \"60 us\""), Contains("is a text; needs a list"));
  const std::string two = vibration("pulse.durations = [\"-1 us\", \"60 us\", 3]");
  CHECK_THAT(two, Contains("\"-1 us\" is out of range"));
  CHECK_THAT(two, Contains("3 has no unit"));
  CHECK_THAT(vibration("pulse.durations = [\"60 us\", \"0.06 ms\"]"), Contains("twice"));
  CHECK_THAT(vibration("fill.fluids = [\"none\", \"beer\"]"), Contains("\"beer\" is not known"));
  CHECK_THAT(piercing("pipette.points = [2, 60]"), Contains("the list has 2 items"));
}

TEST_CASE("all problems of a file are reported together, by line") {
  CHECK_THAT(
      problems_of("study = \"vibration\"\n[pipette]\nlength = 10\nlenght = 3\n[time]\n"
                  "integrator = \"newmrak\"\nstep = \"6 ms\"\n"),
      Equals("s.toml:3: pipette.length: 10 has no unit; needs a unit of length, e.g. \"10 mm\"\n"
             "s.toml:4: pipette.lenght: unknown key of a vibration study; did you mean "
             "pipette.length?\n"
             "s.toml:6: time.integrator: \"newmrak\" is not known here; needs one of newmark, "
             "arkode, modal or transform; did you mean \"newmark\"?\n"
             "s.toml:7: time.step: the step of 6000 us is longer than the run of 5000 us; "
             "choose one below time.end"));
}

TEST_CASE("cross-checks state their numbers") {
  CHECK_THAT(piercing("pipette.inner_diameter = \"12 um\""),
             Contains("the bore of 12 um is not narrower than the pipette of 10 um"));
  CHECK_THAT(piercing("pipette.outer_diameter = \"8 um\""), Contains("s.toml:2: pipette.outer"));
  CHECK_THAT(piercing("grid.domain = \"90 um\""), Contains("90 um do not hold the zona of 100 um"));
  CHECK_THAT(piercing("grid.cell = \"13 um\""), Contains("an eighth of its diameter, 12.5 um"));
  CHECK_THAT(piercing("grid.cell = \"0.1 um\"\nzona.level = 9"),
             Contains("1500 cells along an edge"));
  CHECK_THAT(piercing("zona.level = 4"), Contains("3.46 um apart, more than half a cell of 6 um"));
  CHECK_THAT(piercing("zona.level = 4"), Contains("needs level 5 or a cell of at least 6.92 um"));
  CHECK_THAT(piercing("zona.thickness = \"50 um\""), Contains("not thinner than the radius"));
  CHECK_THAT(piercing("plate.side = \"200 um\""), Contains("more than the domain of 150 um"));
  CHECK(piercing("plate.side = \"200 um\"\nplate.enabled = false").empty());
  CHECK_THAT(piercing("motion.kind = \"trace\""), Contains("motion.trace: is missing"));
  CHECK_THAT(piercing("motion.trace = \"no.csv\""),
             Contains("s.toml:2: motion.trace: there is no file"));
  CHECK_THAT(piercing("motion.kind = \"beam\"\nmotion.axis = \"axial\""),
             Contains("s.toml:3: motion.axis: a beam's tip moves as its support does") &&
                 Contains("pulse.angle = \"0 deg\""));
  CHECK_THAT(piercing("pulse.angle = \"91 deg\""), Contains("s.toml:2: pulse.angle"));
  CHECK_THAT(piercing("pulse.angle = \"1 um\""), Contains("s.toml:2: pulse.angle"));
  CHECK_THAT(piercing("fill.viscosity = \"-1 Pa s\""), Contains("s.toml:2: fill.viscosity"));
  CHECK_THAT(piercing("time.step = \"1 ms\""), Contains("do not fit a simulation of 100 us"));
  CHECK_THAT(piercing("motion.ramp = \"1 ms\""), Contains("longer than the simulation"));
}

TEST_CASE("the study kind must be known") {
  CHECK_THAT(problems_of(""), Contains("s.toml: study: the kind of the study is missing"));
  CHECK_THAT(problems_of("study = \"pierce\""),
             Contains("s.toml:1: study: \"pierce\" is not a study "
                      "kind; needs one of vibration, piercing, comparison, search, "
                      "scene or material_point; did you mean \"piercing\"?"));
  CHECK_THAT(problems_of("study = 3"), Contains("3 is not a study kind"));
}

TEST_CASE("a key does not begin with a letter outside ASCII") {
  // toml++ 3.3 has no answer of its own to these; from each of the 64 blocks that it tells apart.
  for (unsigned letter = 0xA1; letter < 0x10000; letter += 0x1FD) {
    if (letter >= 0xD800 && letter < 0xE000) continue;
    std::string text;
    if (letter >= 0x800) text += static_cast<char>(0xE0 | letter >> 12);
    text += static_cast<char>(letter >= 0x800 ? 0x80 | (letter >> 6 & 0x3F) : 0xC0 | letter >> 6);
    text += static_cast<char>(0x80 | (letter & 0x3F));
    CHECK_THAT(piercing(text + " = 1"), Contains("s.toml:2: this is not TOML"));
    CHECK_THAT(piercing("# " + text + "\n[run]\nname" + text + " = 1"),
               Contains("s.toml:4: this is not TOML"));
  }
}

TEST_CASE("malformed TOML names the line") {
  CHECK_THAT(piercing("[grid\ncell = 1"), Contains("s.toml:2: this is not TOML"));
  CHECK_THAT(piercing("[grid]\ncell = \"1 um\"\ncell = \"2 um\""),
             Contains("s.toml:4: this is not TOML"));
  CHECK_THAT(piercing("[grid]\ncell = 6 um"), Contains("s.toml:3: this is not TOML"));
  CHECK_THAT(piercing("\xff\xfe"), Contains("not TOML"));
  CHECK_THAT(piercing(std::string("a = \"\0\"", 8)), Contains("not TOML"));
  CHECK_THAT(piercing("x = " + std::string(5000, '[')), Contains("not TOML"));
}

TEST_CASE("weird input gives messages of bounded length") {
  const std::string huge(10000, 'k');
  CHECK_THAT(piercing(huge + " = 1"), Contains("(10000 characters)"));
  CHECK(piercing(huge + " = 1").size() < 400);
  CHECK(piercing("grid.cell = \"" + huge + "\"").size() < 400);
  CHECK(piercing("motion.kind = \"" + huge + "\"").size() < 400);
  CHECK(piercing("grid.cell = [" + std::string(10000, '1') + "]").size() < 400);
  CHECK_THAT(piercing("\"\\u001b[31m\" = 1"), !Contains("\x1b"));
  CHECK_THAT(piercing("motion.kind = \"\\u001b[31m\""), Contains("\\x1b"));
  CHECK_THAT(piercing("grid.cell = 1979-05-27"), Contains("a date"));
  CHECK_THAT(piercing("grid.cell = \"1e-320 m\""), Contains("out of range"));
  CHECK_THAT(piercing("motion.trace = \"a\\u0000b\""), Contains("is not a path"));
}

TEST_CASE("overrides replace values and are named in problems") {
  CHECK(piercing("[grid]\ncell = 3\n", {"grid.cell=\"5 um\""}).empty());
  CHECK_THAT(piercing("", {"grid.cell=5"}),
             Equals("--set: grid.cell: 5 has no unit; needs a unit of "
                    "length, e.g. \"6 um\""));
  CHECK_THAT(piercing("", {"grid.cell=5 um"}), Contains("write --set 'grid.cell=\"5 um\"'"));
  CHECK_THAT(piercing("", {"grid.cel=\"5 um\""}), Contains("--set: grid.cel: unknown key"));
  CHECK_THAT(piercing("", {"grid.cell"}), Contains("is not of the form key=value"));
  CHECK_THAT(piercing("", {"=1"}), Contains("is not of the form key=value"));
  CHECK_THAT(piercing("", {"grid.cell=\"5 um\"", "grid.cell=\"4 um\""}), Contains("is set twice"));
  CHECK_THAT(piercing("", {"zona.c0=1\nzona.c1=2"}), Contains("more than one line"));
  CHECK_THAT(piercing("", {"zona.level=4"}), Contains("--set: zona.level: the membrane points"));
  CHECK(problems_of("study = \"vibration\"", {"fill.fluids=[\"none\", \"7 kg/m^3\"]"}).empty());
}

TEST_CASE("files that cannot be read") {
  const ScratchDirectory scratch;
  CHECK_THROWS_WITH(load_configuration(scratch.path() / "no.toml"), Contains("cannot be opened"));
  CHECK_THROWS_WITH(load_configuration(scratch.path()), Contains("is a directory"));
  const auto large = scratch.write("large.toml", std::string(5 << 20, '#'));
  CHECK_THROWS_WITH(load_configuration(large), Contains("larger than 4 MiB"));
}
