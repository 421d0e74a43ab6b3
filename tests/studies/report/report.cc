#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const std::string studies = ZONA_SOURCE_DIR "/studies/";
const std::string small_egg =
    " --set 'grid.cell=\"12 um\"' --set 'grid.domain=\"168 um\"' --set zona.level=4"
    " --set zona.elastic_limit=0.002 --set cytoplasm.points_per_cell=1 --set 'time.end=\"4 us\"'"
    " --set 'output.fields_interval=\"0.5 us\"'";

/// Four of the fifty cases.
const std::string small_vibration =
    studies +
    "vibration.toml"
    " --set 'fill.fluids=[\"mercury\", \"none\"]' --set 'pulse.durations=[\"60 us\", \"300 us\"]'";

/// Runs a study and reports on it; the page.
std::string report_of(const std::string& arguments, const fs::path& directory) {
  const auto run = call("run " + arguments + " --quiet --out " + directory.string());
  INFO(run.text);
  REQUIRE(run.code == 0);
  const auto report = call("report " + directory.string());
  INFO(report.text);
  REQUIRE(report.code == 0);
  CHECK_THAT(report.text, Contains((directory / "report.html").string()));
  const std::string page = read_text(directory / "report.html");
  for (const char* elsewhere : {"src=\"", "@import", "href=\"http"}) {
    const std::size_t found = page.find(elsewhere);
    if (found == std::string::npos) continue;
    INFO(page.substr(found, 40));
    CHECK(page.substr(found, 14).find("src=\"data:") == 0);
  }
  return page;
}

/// What the page is after a few seconds in a browser that is shut off from any network.
Answer in_browser(const fs::path& page) {
  const std::string command =
      "chromium --headless=new --no-sandbox --use-gl=angle --use-angle=swiftshader"
      " --enable-unsafe-swiftshader --host-resolver-rules='MAP * ~NOTFOUND'"
      " --user-data-dir=" +
      (page.parent_path() / "browser").string() +
      " --enable-logging=stderr --virtual-time-budget=20000 --dump-dom file://" + page.string();
  return run_command(command);
}

}  // namespace

TEST_CASE("the report of a piercing has its numbers, charts, pictures and a replay") {
  const ScratchDirectory scratch;
  const auto out = scratch.path() / "out";
  const std::string page = report_of(studies + "piercing_lateral_quick.toml" + small_egg, out);
  for (const char* part : {"<h1>piercing_lateral_quick</h1>", "failed area of the zona",
                           "Failed areas depend on the mesh", "window.zonaReplay", "THREE",
                           "Energies", "grid", "point-steps"}) {
    CHECK_THAT(page, Contains(part));
  }
  for (const char* file : {"failed_area.svg", "failed_area.png", "failed_area.csv", "zona.png"})
    CHECK(fs::file_size(out / "report" / file) > 500);

  if (!has_program("chromium")) {
    WARN("there is no Chromium to look at the page with");
    return;
  }
  // Plays the replay and notes what was drawn before and after.
  std::ofstream(out / "played.html", std::ios::binary) << page << R"(<script>
    const canvas = document.querySelector(".replay canvas");
    const look = () => canvas.toDataURL().length + " " +
      document.querySelector(".replay .controls span").textContent;
    const before = look();
    document.querySelector(".replay button").click();
    setTimeout(() => { document.body.dataset.played = before + " | " + look(); }, 1300);
  </script>)";
  const Answer seen = in_browser(out / "played.html");
  CHECK_THAT(seen.text, !Contains(":CONSOLE"));  // neither errors nor anything else
  const std::size_t played = seen.text.find("data-played=\"");
  REQUIRE(played != std::string::npos);
  const std::string looks =
      seen.text.substr(played + 13, seen.text.find('"', played + 13) - played - 13);
  INFO(looks);
  const std::size_t middle = looks.find(" | ");
  REQUIRE(middle != std::string::npos);
  CHECK(std::stoi(looks) > 5000);  // not an empty canvas
  CHECK(looks.substr(0, middle) != looks.substr(middle + 3));
}

TEST_CASE("every kind of study has a report") {
  const ScratchDirectory scratch;
  const auto out = scratch.path() / "out";
  SECTION("comparison") {
    const std::string page = report_of(studies + "mercury_vs_water.toml" + small_egg +
                                           " --set 'fill.fluids=[\"water\", \"none\"]'",
                                       out);
    CHECK_THAT(page, Contains("<th>water</th><th>none</th>") && Contains("speed of the tip"));
  }
  SECTION("vibration") {
    CHECK_THAT(report_of(small_vibration, out), Contains("Natural frequencies"));
  }
  SECTION("vibration without histories") {
    report_of(small_vibration + " --set output.history=false", out);
  }
  SECTION("material point") {
    CHECK_THAT(report_of(studies + "point_zona.toml", out), Contains("Stress xx over strain xx"));
  }
  SECTION("scene") {
    CHECK_THAT(report_of(studies + "verification/free_fall.toml --set output.fields=true", out),
               Contains("window.zonaReplay"));
  }
}

TEST_CASE("a report on a directory that is not a run is refused with the reason") {
  const ScratchDirectory scratch;
  const auto nothing = call("report " + scratch.path().string());
  CHECK(nothing.code == 2);
  CHECK_THAT(nothing.text, Contains("holds no study.toml"));
  scratch.write("study.toml", "study = 1");
  scratch.write("summary.json", "{");
  const auto broken = call("report " + scratch.path().string());
  CHECK(broken.code == 3);
  CHECK_THAT(broken.text, Contains("no report was written"));
}
