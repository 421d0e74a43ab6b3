#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "coupling/tip_trace.h"
#include "studies/kinds/piercing/case.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pipette_model.h"
#include "studies/parameters/pulse_table.h"
#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A piercing of a few thousand points that runs in a moment.
const std::string small = R"(
study = "piercing"
[motion]
kind = "sine"
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
end = "2 us"
[output]
history_interval = "0.2 us"
fields_interval = "1 us"
)";

nlohmann::json summary_in(const fs::path& directory) {
  return nlohmann::json::parse(read_text(directory / "summary.json"));
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  std::istringstream stream(read_text(file));
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A file at which HDF5 1.10.8 reads from address zero; found by fuzzing, then cut down.
std::string crashing_hdf5() {
  std::string bytes(3113, '\0');
  const auto put = [&](std::size_t at, const std::string& part) {
    bytes.replace(at, part.size(), part);
  };
  put(0, std::string("\211\110\104\106\015\012\032\012", 8));
  put(13, std::string("\010\010\000\004\000\020", 6));
  put(24, std::string("\377\013", 2));
  put(32, std::string("\377\377\377\377\377\377\377\377\000\030", 10));
  put(48, std::string("\377\377\377\377\377\377\377", 7));
  put(64, std::string("\140", 1));
  put(96, std::string("\001\000\001", 3));
  put(104, std::string("\030", 1));
  put(112, std::string("\021\000\020", 3));
  put(128, std::string("\377\377\377\377\377\377\377\377", 8));
  return bytes;
}

}  // namespace

TEST_CASE("a piercing writes its summary, history, fields and log") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  const auto answer =
      call("run " + scratch.write("s.toml", small).string() + " --out " + out.string());
  INFO(answer.text);
  REQUIRE(answer.code == 0);
  CHECK_THAT(answer.text, Contains("million point-steps/s"));
  const auto results = summary_in(out)["results"];
  CHECK(results["fluid"] == "mercury");
  CHECK(results["points"].get<int>() > 3000);
  CHECK(results["steps"].get<int>() ==
        std::ceil(2e-6 / (0.8 * results["critical_time_step"].get<double>())));
  CHECK(results["point_steps_per_second"].get<double>() > 0);
  CHECK(results["wall_seconds"].get<double>() > 0);
  CHECK(results["failed_points"] == 0);
  CHECK(results["failed_area"] == 0);
  CHECK(results["time_of_first_failure"].is_null());
  CHECK(results["simulated_time"].get<double>() == Approx(2e-6));
  const auto lines = lines_of(out / "history.csv");
  CHECK(lines.size() == 12);
  CHECK_THAT(lines[0],
             Contains("time [s]") && Contains("force_y [N]") && Contains("failed_points"));
  CHECK(fs::exists(out / "fields.h5"));
  CHECK_THAT(read_text(out / "fields.xdmf"), Contains("zona"));
  CHECK(fs::exists(out / "log.txt"));
  CHECK(fs::exists(out / "study.toml"));
}

TEST_CASE("all outputs of a piercing are the same to the last bit for one, two and three threads") {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", small).string();
  std::vector<std::string> history, fields;
  for (const char* threads : {"1", "2", "3"}) {
    const fs::path out = scratch.path() / threads;
    REQUIRE(call("run " + file + " --quiet --threads " + threads + " --out " + out.string()).code ==
            0);
    history.push_back(read_text(out / "history.csv"));
    fields.push_back(read_text(out / "fields.h5"));
  }
  CHECK(history[0] == history[1]);
  CHECK(history[0] == history[2]);
  CHECK((fields[0] == fields[1] && fields[0] == fields[2]));
}

TEST_CASE("a comparison runs each fill by its own beam and prints one table") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  const auto answer =
      call("run " ZONA_SOURCE_DIR "/studies/mercury_vs_water.toml --quiet --out " + out.string() +
           " --set 'grid.cell=\"12 um\"' --set 'grid.domain=\"168 um\"' --set zona.level=4"
           " --set cytoplasm.points_per_cell=1 --set 'time.end=\"1 us\"'"
           " --set 'fill.fluids=[\"mercury\", \"2500 kg/m^3\"]'");
  INFO(answer.text);
  REQUIRE(answer.code == 0);
  CHECK_THAT(answer.text,
             Contains("first failure [us]") && Contains("mercury") && Contains("2500 kg/m^3"));
  const auto results = summary_in(out)["results"];
  REQUIRE(results.size() == 2);
  // 0.7562 of the pulse's 17.9 um is the exact tip amplitude of the mercury-filled beam
  // (docs/verification); 80 elements are good to 1.2 % of the peak.
  CHECK(results[0]["tip_amplitude"].get<double>() ==
        Approx(0.7562 * 17.9e-6).margin(0.012 * 17.9e-6));
  CHECK(results[1]["tip_amplitude"].get<double>() > results[0]["tip_amplitude"].get<double>());
  for (const char* folder : {"mercury", "2500_kg_m_3"}) {
    CHECK(fs::exists(out / folder / "history.csv"));
    CHECK(zona::coupling::read_tip_trace((out / folder / "tip.csv").string()).time.size() > 8000);
  }
}

TEST_CASE("a measured trace drives the pipette") {
  const ScratchDirectory scratch;
  scratch.write("trace.csv", "time [us],displacement [um]\n0,0\n1,0\n2,0.1\n3,0.4\n4,0.9\n5,1.6\n");
  const auto file = scratch.write("s.toml", small);
  const std::vector<std::string> overrides{"motion.kind=\"trace\"", "motion.trace=\"trace.csv\"",
                                           "motion.scale=2", "motion.window_start=\"2 us\"",
                                           "time.end=\"3 us\""};
  const auto study = load_configuration(file, overrides);
  const auto piercing = make_piercing_case(study, fills_of(study).front());
  // Between samples of (t - 1 us)^2 the Hermite cubic with second-order slopes is exact.
  const auto at = piercing.setup.pipette.motion(1.5e-6);
  CHECK(at.displacement.y() == Approx(2 * 0.1e-6 * (2.5 * 2.5 - 1)));
  CHECK(at.velocity.y() == Approx(2 * 0.1 * 2 * 2.5));
  CHECK(at.displacement.x() == 0);
}

TEST_CASE("errors that only the model detects are reported before anything is written") {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", small).string();
  const fs::path out = scratch.path() / "out";
  scratch.write("bad.csv", "time [s],displacement [m]\n0,0\n1e-6,x\n2e-6,0\n");
  const auto refused = [&](const std::string& overrides, const std::string& message) {
    for (const std::string& command : {"run --out " + out.string() + " ", std::string("check ")}) {
      const auto answer = call(command + file + overrides);
      INFO(answer.text);
      CHECK(answer.code == 2);
      CHECK_THAT(answer.text, Contains(message));
      CHECK_FALSE(fs::exists(out));
    }
  };
  refused(" --set 'time.step=\"10 ns\"'", "above the critical step of 6.854 ns");
  refused(" --set 'motion.kind=\"beam\"' --set 'motion.window_start=\"6 ms\"'", "the history");
  refused(" --set 'motion.kind=\"beam\"' --set 'beam.length=\"20 um\"'", "beam.length");
  refused(" --set 'motion.kind=\"trace\"' --set 'motion.trace=\"bad.csv\"'", "bad.csv:3:6");
  refused(" --set 'motion.kind=\"trace\"' --set 'motion.trace=\"none.csv\"'", "none.csv");
  refused(" --set zona.level=2", "tear");
  refused(" --set 'grid.cell=\"13 um\"'", "curvature");
  refused(" --set 'pipette.inner_diameter=\"12 um\"'", "bore");
  refused(" --set 'grid.cell=-1'", "no unit");
  refused(" --set 'motion.duration=\"0 us\"'", "motion.duration");
}

TEST_CASE("a trace that makes HDF5 crash is refused") {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", small).string();
  scratch.write("bad.h5", crashing_hdf5());
  const auto answer =
      call("check " + file + " --set 'motion.kind=\"trace\"' --set 'motion.trace=\"bad.h5\"'");
  INFO(answer.text);
  CHECK(answer.code == 2);
  CHECK_THAT(answer.text, Contains("motion.trace") && Contains("bad.h5"));
}

TEST_CASE("a point that leaves the grid ends the run with exit code 3 and keeps the results") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  const auto answer =
      call("run " + scratch.write("s.toml", small).string() + " --quiet --out " + out.string() +
           " --set 'motion.amplitude=\"1 mm\"' --set 'time.end=\"20 us\"'");
  INFO(answer.text);
  CHECK(answer.code == 3);
  CHECK_THAT(answer.text, Contains("point") && Contains("body") && Contains("step"));
  CHECK(lines_of(out / "history.csv").size() > 2);
  CHECK(summary_in(out)["status"] == "failed");
  CHECK(summary_in(out)["results"]["steps"].get<int>() > 0);
  CHECK(fs::exists(out / "fields.xdmf"));
}
