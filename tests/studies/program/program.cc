#include <catch2/catch.hpp>

#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const std::string vibration = ZONA_SOURCE_DIR "/studies/vibration.toml";

}  // namespace

TEST_CASE("the program prints its version and its help") {
  CHECK(call("--version").code == 0);
  CHECK_THAT(call("--version").text,
             Contains("zona 0.") && Contains("(commit ") && Contains(" on "));
  CHECK_THAT(call("--help").text, Contains("reference"));
  CHECK(call("run --help").code == 0);
  CHECK_THAT(call("help grid.cell").text, Contains("grid.cell = \"6 um\""));
  CHECK(call("help gird.cell").code == 2);
  CHECK_THAT(call("help").text, Contains("zona help KEY"));
  CHECK(call("reference").text == read_text(ZONA_SOURCE_DIR "/docs/parameters.md"));
}

TEST_CASE("the program lists kinds and study files") {
  const Answer answer = call("list");
  CHECK(answer.code == 0);
  for (const char* name :
       {"vibration.toml", "piercing_lateral.toml", "piercing_axial.toml", "piercing_beam.toml",
        "mercury_vs_water.toml", "comparison  ", "scene  ", "verification/shock_tube.toml"}) {
    CHECK_THAT(answer.text, Contains(name));
  }
  CHECK_THAT(answer.text, Contains("the zona holds"));
}

TEST_CASE("the program checks studies") {
  CHECK(call("check " + vibration).code == 0);
  CHECK_THAT(call("check " + vibration).text, Contains("6.344e+10 Pa"));
  const Answer answer = call("check --set 'time.step=\"1 us\"' --set pulse.peak=3 " + vibration);
  CHECK(answer.code == 2);
  CHECK_THAT(answer.text, Contains("--set: pulse.peak: 3 has no unit"));
  CHECK_THAT(call("check " + vibration + " --set 'fill.fluids=[\"none\", \"water\"]'").text,
             Contains("[0, 1000] kg/m^3"));
}

TEST_CASE("wrong usage is exit code 2") {
  CHECK(call("").code == 2);
  CHECK(call("fly").code == 2);
  CHECK(call("run").code == 2);
  CHECK(call("run no_such_file.toml").code == 2);
  CHECK(call("run --threads 0 " + vibration).code == 2);
  CHECK_THAT(call("check " + vibration).text, Contains("Here, from trying one"));
  CHECK(call("check --out x " + vibration).code == 2);
}

TEST_CASE("an invalid study writes nothing") {
  const ScratchDirectory scratch;
  const fs::path file =
      scratch.write("s.toml", "study = \"vibration\"\npulse.peak = 3\ntime.end = 4\n");
  const fs::path out = scratch.path() / "out";
  const Answer answer = call("run " + file.string() + " --out " + out.string());
  CHECK(answer.code == 2);
  CHECK_THAT(answer.text, Contains("s.toml:2: pulse.peak: 3 has no unit"));
  CHECK_THAT(answer.text, Contains("s.toml:3: time.end: 4 has no unit"));
  CHECK_THAT(answer.text, Contains("2 problems"));
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("check tries the first steps of a simulation") {
  const std::string fall = ZONA_SOURCE_DIR "/studies/verification/free_fall.toml";
  CHECK_THAT(call("check " + fall).text, Contains("of memory") && Contains("on disk"));
  const Answer thrown =
      call("check " + fall + " --set 'body.0.velocity=[\"0\", \"0\", \"1e5 m/s\"]'");
  CHECK(thrown.code == 0);
  CHECK_THAT(thrown.text, Contains("warning: it fails within its first steps: a point left"));
}
