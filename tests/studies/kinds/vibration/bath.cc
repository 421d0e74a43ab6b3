#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "beam/system/natural_modes.h"
#include "studies/kinds/study_kinds.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pipette_model.h"
#include "studies/parameters/pulse_table.h"
#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;

namespace {

std::string trouble_of(const std::string& text) {
  const ScratchDirectory scratch;
  try {
    const Configuration study = load_configuration(scratch.write("s.toml", text), {});
    find_study_kind(study.kind()).prepare(study);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string kVibration = "study = \"vibration\"\n[fill]\nfluids = [\"water\"]\n";

}  // namespace

TEST_CASE("a pipette has the taper, the columns and the bath of its study") {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", R"(
study = "vibration"
[pipette]
shoulder_outer_diameter = "40 um"
loss_factor = 0.01
[fill]
fluids = ["mercury"]
start = "2 mm"
[[column]]
fluid = "water"
end = "1 mm"
[bath]
model = "frequency"
viscosity = "1 mPa s"
immersed_length = "3 mm"
[time]
integrator = "transform"
)");
  const Configuration study = load_configuration(file, {});
  const zona::beam::Pipette pipette = pipette_from(study, fills_of(study).back());
  const zona::beam::Diameters shoulder = diameters_at(pipette, 0);
  CHECK(shoulder.outer == Approx(40e-6));
  CHECK(shoulder.inner == Approx(32e-6));  // keeps the ratio of the tip
  CHECK(pipette.fill_density == 0);
  REQUIRE(pipette.columns.size() == 2);
  CHECK(pipette.columns[0].start == 2e-3);
  CHECK(pipette.columns[0].end == 10e-3);
  CHECK(pipette.columns[0].density == 13600);
  CHECK(pipette.columns[0].viscosity == 1.526e-3);
  CHECK(pipette.columns[1].end == 1e-3);
  CHECK(pipette.columns[1].density == 1000);
  CHECK(pipette.columns[1].viscosity == 8.9e-4);
  CHECK(pipette.loss_factor == 0.01);
  CHECK(pipette.bath.model == zona::beam::BathModel::frequency);
  CHECK(pipette.bath.liquid.viscosity == Approx(1e-3));
  CHECK(immersed_from(pipette) == Approx(7e-3));
}

TEST_CASE("a profile of diameters is read from a table with units") {
  const ScratchDirectory scratch;
  scratch.write("profile.csv",
                "# measured\ndistance [mm], inner [um], outer [um]\n0, 8, 10\n\n2.5, 16, 20\n");
  const auto file = scratch.write("s.toml", kVibration + "[pipette]\nprofile = \"profile.csv\"\n");
  const Configuration study = load_configuration(file, {});
  const zona::beam::Pipette pipette = pipette_from(study, fills_of(study).back());
  REQUIRE(pipette.profile.size() == 2);
  CHECK(pipette.profile[1].from_tip == Approx(2.5e-3));
  CHECK(pipette.profile[1].outer == Approx(20e-6));
  CHECK(diameters_at(pipette, 8.75e-3).inner == Approx(12e-6));

  scratch.write("profile.csv", "distance [mm], inner [um], outer [kg]\n0, 8, 10\n");
  CHECK_THROWS_WITH(pipette_from(study, fills_of(study).back()),
                    Contains("profile.csv:1:34: \"1 kg\" is not a length"));
}

TEST_CASE("contradictions in taper, fill, bath and pulse are reported") {
  CHECK(trouble_of(kVibration).empty());
  CHECK_THAT(trouble_of(kVibration + "start = \"5 mm\"\nend = \"4 mm\"\n"),
             Contains("fill.end: the fluid begins 5 mm from the tip and ends at 4 mm"));
  CHECK_THAT(trouble_of(kVibration + "start = \"12 mm\"\n"), Contains("fill.start"));
  CHECK_THAT(trouble_of(kVibration + "[[column]]\nstart = \"11 mm\"\n"),
             Contains("the pipette is 10 mm long"));
  CHECK_THAT(trouble_of(kVibration + "[pipette]\nprofile = \"none.csv\"\n"),
             Contains("pipette.profile: there is no file"));
  CHECK_THAT(trouble_of(kVibration +
                        "[pipette]\nprofile = \"p.csv\"\nshoulder_outer_diameter = \"1 mm\"\n"),
             Contains("remove one of them"));
  CHECK_THAT(trouble_of(kVibration + "[pipette]\nshoulder_outer_diameter = \"2 mm\"\n"),
             Contains("at least 10 outer diameters"));
  CHECK_THAT(trouble_of(kVibration + "[pipette]\nloss_factor = -1\n"), Contains("loss_factor"));
  CHECK_THAT(trouble_of(kVibration + "[bath]\nmodel = \"per_mode\"\n"),
             Contains("per_mode is for time.integrator = \"modal\""));
  CHECK_THAT(
      trouble_of(kVibration + "[bath]\nmodel = \"frequency\"\n[time]\nintegrator = \"modal\"\n"),
      Contains("time.integrator: modal superposition takes"));
  CHECK_THAT(trouble_of(kVibration + "[bath]\nmodel = \"frequency\"\ndrag_coefficient = 1\n"
                                     "[time]\nintegrator = \"transform\"\n"),
             Contains("a quadratic drag is not linear"));
  CHECK_THAT(trouble_of(kVibration + "[bath]\nviscosity = \"0 Pa s\"\n"),
             Contains("bath.viscosity"));
  CHECK_THAT(trouble_of(kVibration + "[pulse]\nshape = \"trace\"\n"),
             Contains("pulse.trace: is missing"));
  CHECK_THAT(trouble_of(kVibration + "[pulse]\nshape = \"trace\"\ntrace = \"none.csv\"\n"),
             Contains("pulse.trace: there is no file"));
  CHECK_THAT(trouble_of(kVibration + "[pulse]\ncount = 3\nrepetition_rate = \"10 kHz\"\n"),
             Contains("pulse.repetition_rate: pulse train"));
  CHECK_THAT(trouble_of(kVibration + "[pulse]\nshape = \"sine\"\ncount = 3\n"),
             Contains("a sine does not end"));
}

TEST_CASE("a controller's voltage sets the peak by its gain") {
  const ScratchDirectory scratch;
  const auto file = scratch.write(
      "s.toml", kVibration + "[pulse]\npeak = \"auto\"\nvoltage = \"5 V\"\ngain = \"2 um/V\"\n");
  const Configuration study = load_configuration(file, {});
  CHECK(study.read<Pulse>().support_peak() == Approx(10e-6));
  CHECK_THAT(study.read<Pulse>().calibration_text(),
             Contains("5 V times 2 um/V is 10 um") && Contains("5 to 15 um"));
  CHECK(peak_displacement(support_motion(study, 60e-6)) == Approx(10e-6));
}

TEST_CASE("the gain's uncertainty is that of the tip's displacement") {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", kVibration + R"([pulse]
peak = "auto"
gain_uncertainty = 0.2
durations = ["60 us"]
[time]
integrator = "modal"
end = "1 ms"
)");
  const Answer run =
      call("run " + file.string() + " --quiet --out " + (scratch.path() / "out").string());
  INFO(run.text);
  REQUIRE(run.code == 0);
  CHECK_THAT(run.text, Contains("10 V times 1.79 um/V is 17.9 um"));
  std::ifstream stream(scratch.path() / "out/summary.json");
  const auto result = nlohmann::json::parse(stream)["results"][0];
  const double peak = std::abs(result["peak_displacement"].get<double>());
  CHECK(result["peak_displacement_range"][0] == Approx(0.8 * peak));
  CHECK(result["peak_displacement_range"][1] == Approx(1.2 * peak));
}

TEST_CASE("a support can follow a measured trace") {
  const ScratchDirectory scratch;
  scratch.write("support.csv", "time [us], displacement [um]\n0, 0\n20, 4\n50, 1\n80, 0\n");
  const auto file =
      scratch.write("s.toml", kVibration +
                                  "[pulse]\nshape = \"trace\"\ntrace = \"support.csv\"\n"
                                  "[time]\nend = \"1 ms\"\nintegrator = \"modal\"\n");
  const Answer run =
      call("run " + file.string() + " --quiet --out " + (scratch.path() / "out").string());
  INFO(run.text);
  REQUIRE(run.code == 0);
  CHECK_THAT(run.text, Contains("trace"));
}

TEST_CASE("a run in a bath warns where its load is not valid") {
  const ScratchDirectory scratch;
  const auto file = scratch.write("s.toml", kVibration + R"([pulse]
durations = ["60 us"]
[bath]
model = "frequency"
immersed_length = "50 um"
wall_distance = "20 um"
[time]
integrator = "transform"
end = "2 ms"
)");
  const Answer run =
      call("run " + file.string() + " --quiet --out " + (scratch.path() / "out").string());
  INFO(run.text);
  REQUIRE(run.code == 0);
  CHECK_THAT(run.text, Contains("1 of 1 runs leave the range of the bath's load"));
  CHECK_THAT(run.text, Contains("of its diameter"));
  CHECK_THAT(run.text, Contains("Reynolds number"));
  CHECK_THAT(run.text, Contains("50 um are immersed, 5 diameters"));
  CHECK_THAT(run.text, Contains("the wall is 20 um away"));
  std::ifstream stream(scratch.path() / "out/summary.json");
  const auto result = nlohmann::json::parse(stream)["results"][0];
  CHECK(result["warnings"].size() == 4);
  CHECK(result["damping_ratios"][0] > 0);
  CHECK(result["residual_amplitude"] > 0);
}
