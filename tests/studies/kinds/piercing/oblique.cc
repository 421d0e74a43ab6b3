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

const std::string kPiercing = R"(
study = "piercing"
[motion]
kind = "beam"
[grid]
cell = "12 um"
domain = "168 um"
[zona]
level = 4
[cytoplasm]
points_per_cell = 1
[pipette]
points = [1, 12, 4]
[beam]
elements = 20
end = "0.5 ms"
[time]
end = "2 us"
)";

PiercingCase piercing_at(const std::string& angle) {
  const ScratchDirectory scratch;
  const auto study =
      load_configuration(scratch.write("s.toml", kPiercing), {"pulse.angle=\"" + angle + "\""});
  return make_piercing_case(study, fills_of(study).front());
}

nlohmann::json vibration_at(const std::string& angle, const std::string& more = "") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  const auto answer =
      call("run " ZONA_SOURCE_DIR "/studies/vibration.toml --quiet --out " + out.string() +
           " --set 'fill.fluids=[\"mercury\"]'" +
           " --set 'pulse.durations=[\"60 us\"]' --set 'pulse.angle=\"" + angle + "\"'" + more);
  INFO(answer.text);
  REQUIRE(answer.code == 0);
  return nlohmann::json::parse(read_text(out / "summary.json"))["results"][0];
}

double number(const nlohmann::json& result, const char* key) {
  return result[key].get<double>();
}

}  // namespace

TEST_CASE("an oblique pulse moves the tip by its sine across and its cosine along the pipette") {
  for (const char* more : {"", " --set 'time.integrator=\"transform\"'"}) {
    const auto lateral = vibration_at("90 deg", more), axial = vibration_at("0 deg", more),
               oblique = vibration_at("45 deg", more);
    CHECK_FALSE(lateral.contains("axial_amplitude_ratio"));
    CHECK(number(axial, "amplitude_ratio") == 0);
    CHECK(number(axial, "axial_peak_displacement") > 17.9e-6);
    for (const auto& [key, from] :
         {std::pair("amplitude_ratio", &lateral), std::pair("peak_displacement", &lateral),
          std::pair("axial_amplitude_ratio", &axial), std::pair("axial_peak_displacement", &axial)})
      CHECK(number(oblique, key) == Approx(std::sqrt(0.5) * number(*from, key)).epsilon(1e-9));
  }
}

TEST_CASE("a piercing after an oblique pulse moves both ways, at a right angle across only") {
  const PiercingCase lateral = piercing_at("90 deg"), axial = piercing_at("0 deg"),
                     oblique = piercing_at("30 deg");
  CHECK_FALSE(lateral.axial_tip_history.has_value());
  CHECK_FALSE(axial.axial_tip_history.has_value());
  REQUIRE(oblique.axial_tip_history.has_value());
  CHECK(oblique.window_start == Approx(axial.window_start).epsilon(1e-3));
  CHECK(lateral.window_start > 50e-6);
  const auto across = lateral.setup.pipette.motion(1e-6).displacement;
  CHECK((across.x() == 0 && across.y() != 0 && across.z() == 0));
  const auto along = axial.setup.pipette.motion(1e-6).displacement;
  CHECK((along.x() < 0 && along.y() == 0 && along.z() == 0));
  CHECK(oblique.setup.pipette.motion(1e-6).displacement.x() ==
        Approx(std::sqrt(0.75) * along.x()).epsilon(1e-9));
  CHECK(oblique.tip_history->displacement.back() ==
        Approx(0.5 * lateral.tip_history->displacement.back()).epsilon(1e-9));
}

TEST_CASE("a short oblique piercing runs and reports both motions of the tip") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  const auto answer = call("run " + scratch.write("s.toml", kPiercing).string() +
                           " --quiet --set 'pulse.angle=\"45 deg\"' --out " + out.string());
  INFO(answer.text);
  REQUIRE(answer.code == 0);
  const auto result = nlohmann::json::parse(read_text(out / "summary.json"))["results"];
  const auto largest = [&](const char* file) {
    double value = 0;
    for (const double u : zona::coupling::read_tip_trace((out / file).string()).displacement)
      value = std::max(value, std::abs(u));
    return value;
  };
  CHECK(largest("tip.csv") == Approx(number(result, "tip_amplitude")));
  CHECK(largest("tip_axial.csv") == Approx(number(result, "axial_tip_amplitude")));
  CHECK(number(result, "axial_tip_amplitude") > std::sqrt(0.5) * 17.9e-6);
}

TEST_CASE("an angle that a vibration study cannot take is refused") {
  const auto refused = [](const std::string& more, const std::string& message) {
    const auto answer = call("check " ZONA_SOURCE_DIR "/studies/vibration.toml" + more);
    INFO(answer.text);
    CHECK(answer.code == 2);
    CHECK_THAT(answer.text, Contains(message));
  };
  const std::string oblique = " --set 'pulse.angle=\"45 deg\"'";
  refused(oblique + " --set 'pipette.supports=\"pinned\"'", "moved across its axis");
  refused(" --set 'pulse.angle=\"-1 deg\"'", "pulse.angle");
  refused(" --set 'fill.viscosity=\"0 Pa s\"'", "fill.viscosity");
}
