#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "beam/exact/cantilever.h"
#include "studies/kinds/vibration/study.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pipette_model.h"
#include "studies/parameters/pulse_table.h"
#include "studies/program/exit_code.h"
#include "studies/program/run_study.h"
#include "studies/run/progress.h"
#include "studies/run/run_directory.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;

namespace {

const char* const kSmallStudy = R"(
study = "vibration"
[fill]
fluids = ["none", "mercury", "2500 kg/m^3"]
[pulse]
durations = ["120 us", "60 us"]
[time]
end = "1 ms"
)";

/// Sends std::cout elsewhere while it lives.
class QuietOutput {
 public:
  QuietOutput() : old_(std::cout.rdbuf(caught_.rdbuf())) {}
  ~QuietOutput() { std::cout.rdbuf(old_); }
  std::string text() const { return caught_.str(); }

 private:
  std::ostringstream caught_;
  std::streambuf* old_;
};

/// Runs a study text into `out`; returns what it prints.
std::string run(const std::string& text, const std::filesystem::path& out, int threads,
                const std::vector<std::string>& overrides = {}) {
  const ScratchDirectory scratch;
  RunOptions options;
  options.file = scratch.write("s.toml", text);
  options.overrides = overrides;
  options.out = out;
  options.out_given = true;
  options.quiet = true;
  options.threads = threads;
  const QuietOutput output;
  REQUIRE(run_study(options) == exit_ok);
  return output.text();
}

nlohmann::json results_in(const std::filesystem::path& directory) {
  return nlohmann::json::parse(read_text(directory / "summary.json"))["results"];
}

}  // namespace

TEST_CASE("a vibration study reports every fluid and duration in the order of the file") {
  const ScratchDirectory scratch;
  const std::string printed = run(kSmallStudy, scratch.path() / "out", 2);
  CHECK_THAT(printed, Contains("120 us") && Contains("2500 kg/m^3"));
  const auto results = results_in(scratch.path() / "out");
  REQUIRE(results.size() == 6);
  CHECK(results[0]["fluid"] == "none");
  CHECK(results[0]["pulse_duration"] == 120e-6);
  CHECK(results[3]["fluid"] == "mercury");
  CHECK(results[3]["fluid_density"] == 13600);
  CHECK(results[3]["pulse_duration"] == 60e-6);
  CHECK(results[5]["fluid_density"] == 2500);
  // Table 5.6, as far as twenty elements resolve it.
  const double table[] = {27.729, 173.791, 486.666, 953.692, 1576.353, 2354.919};
  for (int n = 0; n < 6; ++n)
    CHECK(results[2]["natural_frequencies"][n].get<double>() == Approx(table[n]).epsilon(1e-3));
  for (const auto& result : results) {
    const double peak = result["peak_displacement"];
    CHECK(result["amplitude_ratio"].get<double>() == Approx(std::abs(peak) / 17.9e-6));
    CHECK(result["time_of_peak"].get<double>() <= 1e-3 + 0.6e-6);
    CHECK(std::abs(result["peak_velocity"].get<double>()) > 0);
  }
}

TEST_CASE("a vibration study does not depend on the number of threads") {
  const ScratchDirectory scratch;
  run(kSmallStudy, scratch.path() / "one", 1);
  run(kSmallStudy, scratch.path() / "three", 3);
  CHECK(results_in(scratch.path() / "one") == results_in(scratch.path() / "three"));
  CHECK(read_text(scratch.path() / "one" / "history.csv") ==
        read_text(scratch.path() / "three" / "history.csv"));
}

TEST_CASE("the history has one row per sample and one column per case") {
  const ScratchDirectory scratch;
  run(kSmallStudy, scratch.path() / "out", 2);
  std::istringstream history(read_text(scratch.path() / "out" / "history.csv"));
  std::string line;
  std::getline(history, line);
  CHECK_THAT(line, Contains("time [s]") && Contains("mercury 60 us [m]"));
  CHECK(std::count(line.begin(), line.end(), ',') == 6);
  int rows = 0;
  while (std::getline(history, line)) ++rows;
  CHECK(rows == 1668);  // 0 to 1000.2 us by 0.6 us
}

TEST_CASE("a sweep keeps the amplitudes and no histories") {
  const ScratchDirectory scratch;
  const auto out = scratch.path() / "out";
  run(kSmallStudy, out, 2, {"output.history=false"});
  CHECK_FALSE(std::filesystem::exists(out / "history.csv"));
  std::istringstream table(read_text(out / "amplitudes.csv"));
  std::string line;
  std::getline(table, line);
  CHECK_THAT(line, Contains("fluid,fluid_density [kg/m^3]") && Contains("peak_velocity [m/s]"));
  const auto results = results_in(out);
  REQUIRE(results.size() == 6);
  for (const auto& result : results) {
    REQUIRE(std::getline(table, line));
    CHECK_THAT(line, Catch::StartsWith(result["fluid"].get<std::string>() + ","));
    CHECK_THAT(line, Contains(fmt::format(",{},", result["amplitude_ratio"].get<double>())));
  }
  CHECK_FALSE(std::getline(table, line));
}

TEST_CASE("a fine mesh with modal superposition gives the exact amplitudes") {
  const ScratchDirectory scratch;
  run(kSmallStudy, scratch.path() / "out", 2,
      {"pipette.elements=160", "time.integrator=\"modal\""});
  for (const auto& result : results_in(scratch.path() / "out")) {
    zona::beam::Pipette pipette;
    pipette.fill_density = result["fluid_density"];
    const zona::beam::ExactCantilever exact(uniform_beam(pipette), 1000);
    const auto pulse = zona::beam::triangular_pulse(1, result["pulse_duration"]);
    // The greatest error of 160 elements in docs/verification/beam.md.
    CHECK(result["amplitude_ratio"].get<double>() ==
          Approx(amplitude_ratio(exact.tip_history(pulse, {1e-3, 0.6e-6}), 1)).margin(0.005));
  }
}

TEST_CASE("the three integrators of a study give one answer") {
  const ScratchDirectory scratch;
  const std::vector<std::string> common = {"pipette.elements=8", "time.step=\"0.1 us\"",
                                           "fill.fluids=[\"water\"]"};
  std::vector<double> ratios;
  for (const std::string name : {"newmark", "modal", "arkode"}) {
    auto overrides = common;
    overrides.push_back("time.integrator=\"" + name + "\"");
    run(kSmallStudy, scratch.path() / name, 1, overrides);
    ratios.push_back(results_in(scratch.path() / name)[0]["amplitude_ratio"]);
  }
  // Newmark: (omega dt)^2 / 12 of phase per radian for modes below 5e5 rad/s.
  CHECK(ratios[0] == Approx(ratios[1]).margin(2e-3));
  CHECK(ratios[2] == Approx(ratios[1]).margin(1e-5));
}
