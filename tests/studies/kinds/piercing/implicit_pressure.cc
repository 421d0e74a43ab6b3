#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A piercing of a few thousand points, 0.85 m/s at the start, with implicit pressure.
const std::string small = R"(
study = "piercing"
[motion]
kind = "sine"
ramp = "0 s"
[grid]
cell = "12 um"
domain = "168 um"
[zona]
level = 4
[cytoplasm]
points_per_cell = 1
[pipette]
points = [1, 12, 4]
[time]
end = "4 us"
[numerics]
pressure = "implicit"
[output]
history_interval = "1 us"
fields_interval = "2 us"
)";

nlohmann::json summary_in(const fs::path& directory) {
  return nlohmann::json::parse(read_text(directory / "summary.json"));
}

}  // namespace

TEST_CASE("implicit pressure steps by motion, and any number of threads gives the same bits") {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", small).string();
  std::vector<std::string> histories;
  for (const char* threads : {"1", "2", "3"}) {
    const fs::path out = scratch.path() / threads;
    const auto answer =
        call("run " + file + " --quiet --threads " + threads + " --out " + out.string());
    INFO(answer.text);
    REQUIRE(answer.code == 0);
    histories.push_back(read_text(out / "history.csv"));
    const auto results = summary_in(out)["results"];
    // 0.05 of a cell at the sine's greatest speed, 2 pi 13.5 um / 100 us.
    const double longest = 0.05 * 12e-6 / (2 * M_PI * 13.5e-6 / 100e-6);
    CHECK(results["steps"] == std::ceil(4e-6 / longest));
    CHECK(results["pressure_iterations"].get<double>() > 1);
  }
  CHECK(histories[0] == histories[1]);
  CHECK(histories[0] == histories[2]);
}

TEST_CASE("zona check says what binds an implicit step") {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", small).string();
  CHECK_THAT(call("check " + file).text, Contains("bound by motion at 0.848 m/s"));
  CHECK_THAT(
      call("check " + file + " --set time.travel=0.5 --set medium.viscosity='\"1 Pa s\"'").text,
      Contains("bound by 'medium': a viscosity of 1 Pa s"));
}

TEST_CASE("implicit pressure refuses what it cannot do, with the key") {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", small).string();
  const auto refusal = [&](const std::string& change) {
    const auto answer = call("check " + file + " --set '" + change + "'");
    CHECK(answer.code == 2);
    return answer.text;
  };
  CHECK_THAT(refusal("numerics.interpolation=\"quadratic\""),
             Contains("numerics.pressure") && Contains("numerics.interpolation = \"linear\""));
  CHECK_THAT(refusal("numerics.damping=0.1"),
             Contains("numerics.pressure") && Contains("numerics.damping"));
  CHECK_THAT(refusal("numerics.pressure=\"semi\""), Contains("numerics.pressure"));
  CHECK_THAT(refusal("numerics.pressure_tolerance=0.5"), Contains("numerics.pressure_tolerance"));
  CHECK_THAT(refusal("time.travel=2"), Contains("time.travel"));
  CHECK_THAT(refusal("time.step=\"20 us\""), Contains("time.step"));
  CHECK_THAT(refusal("time.step=\"4 us\" --set time.end=\"100 us\""), Contains("time.step"));
}
