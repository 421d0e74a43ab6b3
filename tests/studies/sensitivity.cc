#include <catch2/catch.hpp>
#include <cmath>

#include "beam/transfer_function.h"
#include "studies/beam_parameters.h"
#include "studies/sensitivity.h"
#include "studies/study_kinds.h"
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

SensitivityResult of(const std::vector<std::string>& overrides, bool derive = true,
                     double density = 13600, double duration = 80e-6) {
  const ScratchDirectory scratch;
  const Configuration study = load_configuration(scratch.write("s.toml", kStudy), overrides);
  VibrationCase setup = vibration_cases(study).front();
  setup.fluid_density = density;
  setup.pulse_duration = duration;
  return derive ? beam_sensitivities(study, setup) : beam_response(study, setup);
}

std::string value_of(const InputSensitivity& input, double factor) {
  char text[64];
  std::snprintf(text, sizeof text, "%.15g", input.value * factor);
  if (input.unit.empty()) return input.key + "=" + text;
  return input.key + "=\"" + text + " " + input.unit + "\"";
}

}  // namespace

TEST_CASE("sensitivities are those of differences, for every input") {
  const SensitivityResult base = of({});
  CHECK(base.inputs.size() >= 15);
  CHECK(base.without.empty());
  for (const InputSensitivity& input : base.inputs) {
    const double e = 2e-4;
    const auto moved = [&](double factor) {
      if (input.key == "fill.fluids") return of({}, false, 13600 * factor);
      if (input.key == "pulse.durations") return of({}, false, 13600, 80e-6 * factor);
      return of({value_of(input, factor)}, false);
    };
    const SensitivityResult more = moved(1 + e), less = moved(1 - e);
    const double span = 2 * e * input.value;
    INFO(input.key << " = " << input.value << " " << input.unit);
    // The differences err by their second order and by the interpolation between samples, both
    // against the greatest change that any input makes.
    const double scale = base.amplitude / input.value;
    CHECK(input.amplitude ==
          Approx((more.amplitude - less.amplitude) / span).epsilon(2e-3).margin(2e-4 * scale));
    CHECK(input.peak_velocity == Approx((more.peak_velocity - less.peak_velocity) / span)
                                     .epsilon(5e-3)
                                     .margin(2e-3 * base.peak_velocity / input.value));
    REQUIRE((base.ring_down && more.ring_down && less.ring_down && input.ring_down));
    CHECK(*input.ring_down == Approx((*more.ring_down - *less.ring_down) / span)
                                  .epsilon(5e-3)
                                  .margin(2e-3 * *base.ring_down / input.value));
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
