#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "beam/frequency/transfer_function.h"
#include "studies/kinds/study_kinds.h"
#include "studies/kinds/vibration/case.h"
#include "studies/kinds/vibration/sensitivity.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pipette_model.h"
#include "studies/parameters/pulse_table.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;

namespace {

const char* const kStudy = R"(
study = "vibration"
[pipette]
elements = 24
shoulder_outer_diameter = "30 um"
loss_factor = 0.1
[fill]
fluids = ["mercury"]
start = "1.3 mm"
[[column]]
fluid = "water"
end = "0.9 mm"
[bath]
model = "frequency"
immersed_length = "4.1 mm"
[pulse]
shape = "trapezoid"
durations = ["80 us"]
[time]
end = "2 ms"
step = "0.3 us"
integrator = "transform"
)";

/// What is the case's own, by its key: factors.
using CaseFactors = std::map<std::string, double>;

SensitivityResult of(const std::vector<std::string>& overrides, bool derive = true,
                     Direction direction = Direction::across, const CaseFactors& factors = {}) {
  const ScratchDirectory scratch;
  const Configuration study = load_configuration(scratch.write("s.toml", kStudy), overrides);
  VibrationCase setup = vibration_cases(study).front();
  for (const auto& [key, factor] : factors)
    (key == "fill.fluids"      ? setup.fluid.density
     : key == "fill.viscosity" ? setup.fluid.viscosity
                               : setup.pulse_duration) *= factor;
  return derive ? beam_sensitivities(study, setup, direction)
                : beam_response(study, setup, direction);
}

std::string value_of(const InputSensitivity& input, double factor) {
  char text[64];
  std::snprintf(text, sizeof text, "%.15g", input.value * factor);
  if (input.unit.empty()) return input.key + "=" + text;
  return input.key + "=\"" + text + " " + input.unit + "\"";
}

/// Holds the derivatives by every input against differences.
void check_against_differences(const SensitivityResult& base,
                               const std::vector<std::string>& overrides, Direction direction) {
  for (const InputSensitivity& input : base.inputs) {
    const double e = 2e-4;
    const auto moved = [&](double factor) {
      for (const char* own : {"fill.fluids", "fill.viscosity", "pulse.durations"})
        if (input.key == own) return of(overrides, false, direction, {{own, factor}});
      std::vector<std::string> all{value_of(input, factor)};
      for (const std::string& given : overrides)
        if (given.rfind(input.key + "=", 0) != 0) all.push_back(given);
      return of(all, false, direction);
    };
    const SensitivityResult more = moved(1 + e), less = moved(1 - e);
    const double span = 2 * e * input.value;
    INFO(input.key << " = " << input.value << " " << input.unit);
    // The differences err by their second order and by the interpolation between samples, both
    // against the greatest change that any input makes. Along itself the pipette is a rod, at whose
    // tip the corners of the support's motion arrive as corners.
    const bool is_rod = direction == Direction::along;
    const double scale = base.amplitude / input.value;
    CHECK(input.amplitude == Approx((more.amplitude - less.amplitude) / span)
                                 .epsilon(2e-3)
                                 .margin((is_rod ? 1e-3 : 2e-4) * scale));
    REQUIRE(input.peak_velocity.has_value() == !is_rod);
    if (!is_rod)
      CHECK(*input.peak_velocity == Approx((more.peak_velocity - less.peak_velocity) / span)
                                        .epsilon(5e-3)
                                        .margin(2e-3 * base.peak_velocity / input.value));
    REQUIRE((base.ring_down && more.ring_down && less.ring_down && input.ring_down));
    CHECK(*input.ring_down == Approx((*more.ring_down - *less.ring_down) / span)
                                  .epsilon(5e-3)
                                  .margin(2e-3 * std::abs(*base.ring_down) / input.value));
  }
}

bool has(const SensitivityResult& result, const std::string& key) {
  return std::any_of(result.inputs.begin(), result.inputs.end(),
                     [&](const InputSensitivity& input) { return input.key == key; });
}

}  // namespace

TEST_CASE("sensitivities agree with differences for every input") {
  const SensitivityResult base = of({});
  CHECK(base.inputs.size() >= 15);
  CHECK(base.without.empty());
  CHECK_FALSE(has(base, "fill.viscosity"));
  CHECK_FALSE(has(base, "pulse.angle"));
  check_against_differences(base, {}, Direction::across);
}

TEST_CASE("after an oblique pulse there are sensitivities across and along the pipette") {
  const std::vector<std::string> oblique{"pulse.angle=\"40 deg\"", "pulse.shape=\"half_sine\"",
                                         "time.step=\"0.1 us\"", "time.end=\"0.4 ms\"",
                                         "column=[]"};
  const SensitivityResult along = of(oblique, true, Direction::along);
  CHECK(along.without.empty());
  for (const char* key : {"fill.viscosity", "bath.viscosity", "pulse.angle", "fill.fluids"})
    CHECK(has(along, key));
  check_against_differences(along, oblique, Direction::along);
  // The parts of the pulse are its sine and its cosine.
  for (const auto& [direction, expected] :
       {std::pair(Direction::across, 1 / std::tan(40 * M_PI / 180)),
        std::pair(Direction::along, -std::tan(40 * M_PI / 180))}) {
    const SensitivityResult result = of(oblique, true, direction);
    for (const InputSensitivity& input : result.inputs)
      if (input.key == "pulse.angle")
        CHECK(input.amplitude / result.amplitude == Approx(expected).epsilon(1e-9));
  }
}

TEST_CASE("sensitivities obey the laws of dimensions and of proportion") {
  // In vacuum, without loss: amplitude / peak depends on E I / (rho A) T^2 / L^4 alone.
  const SensitivityResult result =
      of({"bath.model=\"none\"", "pipette.loss_factor=0", "time.end=\"0.8 ms\"",
          "pipette.shoulder_outer_diameter=\"auto\"", "fill.start=\"0 mm\"", "column=[]"});
  const auto elasticity = [&](const std::string& key) {
    for (const InputSensitivity& input : result.inputs)
      if (input.key == key) return input.amplitude * input.value / result.amplitude;
    return std::nan("");
  };
  CHECK(elasticity("pulse.peak") == Approx(1).epsilon(1e-9));
  // Young's modulus against both densities: frequencies stay if all are doubled.
  CHECK(elasticity("pipette.youngs_modulus") ==
        Approx(-elasticity("pipette.density") - elasticity("fill.fluids")).epsilon(1e-6));
  // All lengths of the pipette doubled halve its frequencies, as E / 4 does.
  const double lengths = elasticity("pipette.length") + elasticity("pipette.outer_diameter") +
                         elasticity("pipette.inner_diameter");
  CHECK(lengths == Approx(-2 * elasticity("pipette.youngs_modulus")).epsilon(1e-6));
}

TEST_CASE("an input at a kink has no sensitivity, and is named") {
  const SensitivityResult result = of({"bath.immersed_length=\"10 mm\""});
  CHECK(result.without == std::vector<std::string>{"pipette.length", "bath.immersed_length"});
  CHECK_THROWS_AS(of({"bath.drag_coefficient=1", "time.integrator=\"newmark\""}),
                  std::invalid_argument);
}
