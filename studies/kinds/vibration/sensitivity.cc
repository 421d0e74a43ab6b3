#include "studies/kinds/vibration/sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "beam/frequency/tip_response.h"
#include "beam/frequency/transfer_function.h"
#include "beam/frequency/transfer_sensitivity.h"
#include "studies/kinds/vibration/pulses_table.h"
#include "studies/parameters/bath_table.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/beam_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pipette_model.h"
#include "studies/parameters/pulse_table.h"

namespace zona::studies {

namespace {

using Complex = std::complex<double>;

/// Step of an input, relative to its value. Functions that are not polynomials of an input err by
/// its fourth power.
constexpr double relative_step = 2.5e-4;

/// An input of a study, and the study and case with the input multiplied by a factor.
struct Input {
  std::string key;
  std::string unit;
  double value;
  bool moves_support;  ///< true for inputs of the pulse
  std::function<std::pair<Configuration, VibrationCase>(double factor)> times;

  double step() const { return relative_step * value; }
};

Configuration scaled(const Configuration& study, const std::string& key, double factor) {
  Configuration moved = study;
  Setting setting = study.setting(key);
  for (double& number : setting.numbers) number *= factor;
  moved.set(key, setting);
  return moved;
}

/// Adds the inputs that a case takes from its own fluid and pulse instead of the study.
void add_case_inputs(const Configuration& study, const VibrationCase& setup,
                     std::vector<Input>& inputs) {
  const auto add = [&](const std::string& key, const char* unit, bool moves_support,
                       double& (*member)(VibrationCase&)) {
    VibrationCase own = setup;
    if (member(own) == 0) return;
    inputs.push_back(
        {key, unit, member(own), moves_support, [&study, setup, member](double factor) {
           VibrationCase moved = setup;
           member(moved) *= factor;
           return std::pair(study, moved);
         }});
  };
  add(study.key(&Fills::fluids), "kg/m^3", false,
      [](VibrationCase& c) -> double& { return c.fluid.density; });
  add(study.key(&FillPlace::viscosity), "Pa s", false,
      [](VibrationCase& c) -> double& { return c.fluid.viscosity; });
  add(study.key(&Pulses::durations), "s", true,
      [](VibrationCase& c) -> double& { return c.pulse_duration; });
}

/// All single quantities and numbers that describe pipette, liquids and pulse.
std::vector<Input> inputs_of(const Configuration& study, const VibrationCase& setup) {
  std::vector<Input> inputs;
  const bool moves_along = study.read<Pulse>().direction().along != 0;
  const std::string pulse = study.schema().binding<Pulse>().section;
  const auto add = [&](const std::string& key) {
    // The case has its own viscosity. At a right angle nothing moves along the pipette, so the
    // angle has no effect to first order.
    if (key == study.key(&FillPlace::viscosity)) return;
    if (key == study.key(&Pulse::angle) && !moves_along) return;
    const Parameter& parameter = *study.schema().find(key);
    const bool is_number =
        parameter.kind == Parameter::Kind::quantity || parameter.kind == Parameter::Kind::number;
    if (!is_number || parameter.is_list || study.is_auto(key)) return;
    const double value = study.setting(key).numbers.front();
    if (value == 0) return;
    inputs.push_back({key, parameter.unit, value, key.rfind(pulse + ".", 0) == 0,
                      [&study, setup, key](double factor) {
                        return std::pair(scaled(study, key, factor), setup);
                      }});
  };
  const Schema& schema = study.schema();
  std::vector<std::string> sections{schema.binding<Beam>().section, schema.binding<Fills>().section,
                                    schema.binding<FluidColumn>().section, pulse};
  if (study.value(&Bath::model) != beam::BathModel::none)
    sections.push_back(schema.binding<Bath>().section);
  for (const std::string& table : study.tables()) {
    const std::string section = table.substr(0, table.find('.'));
    if (std::find(sections.begin(), sections.end(), section) == sections.end()) continue;
    for (const std::string& key : study.keys_of(table)) add(key);
  }
  add_case_inputs(study, setup, inputs);
  return inputs;
}

beam::BeamSystem beam_of(const Configuration& study, const VibrationCase& setup,
                         Direction direction) {
  const beam::Pipette pipette = pipette_from(study, setup.fluid);
  if (direction == Direction::along) return beam::axial_rod(pipette);
  return study.value(&Support::supports) == Supports::pinned ? beam::simply_supported(pipette)
                                                             : beam::cantilever(pipette);
}

/// Motion of the support in a direction.
beam::SupportMotion motion_of(const Configuration& study, const VibrationCase& setup,
                              Direction direction) {
  const beam::SupportMotion motion = support_motion(study, setup.pulse_duration);
  const PulseDirection parts = study.read<Pulse>().direction();
  const double part = direction == Direction::across ? parts.across : parts.along;
  return part == 1 ? motion : beam::scaled(motion, part);
}

/// The beam with an input moved; absent if its structure changes with the input.
std::optional<beam::ParameterStencil> stencil_of(const Input& input, Direction direction,
                                                 const beam::BeamSystem& system) {
  beam::ParameterStencil stencil;
  stencil.step = input.step();
  for (std::size_t i = 0; i < stencil.moved.size(); ++i) {
    const auto [study, setup] = input.times(1 + beam::stencil_places[i] * relative_step);
    stencil.moved[i] = beam_of(study, setup, direction);
    if (!beam::have_same_structure(stencil.moved[i], system)) return std::nullopt;
  }
  return stencil;
}

/// Derivatives of the kinks of the support's motion; empty if their number changes with the input.
std::vector<beam::KinkDerivative> kinks_of(const Input& input, Direction direction,
                                           const beam::SupportMotion& motion) {
  std::array<beam::SupportMotion, 4> moved;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const auto [study, setup] = input.times(1 + beam::stencil_places[i] * relative_step);
    moved[i] = motion_of(study, setup, direction);
  }
  return beam::kink_derivatives(motion, moved, input.step());
}

/// The inputs with an effect on the response, and how they change beam and pulse.
struct ActingInputs {
  std::vector<Input> of_beam;
  std::vector<beam::ParameterStencil> stencils;  ///< one per input of the beam
  std::vector<Input> of_pulse;
  std::vector<std::vector<beam::KinkDerivative>> kinks;  ///< one row per input of the pulse
  std::vector<std::string> without;                      ///< keys without a derivative
};

ActingInputs acting_inputs(const Configuration& study, const VibrationCase& setup,
                           Direction direction, const beam::BeamSystem& system,
                           const beam::SupportMotion& motion) {
  ActingInputs acting;
  for (const Input& input : inputs_of(study, setup)) {
    if (input.moves_support) {
      const auto kinks = kinks_of(input, direction, motion);
      if (kinks.empty()) acting.without.push_back(input.key);
      if (!beam::has_effect(kinks, input.value)) continue;
      acting.kinks.push_back(kinks);
      acting.of_pulse.push_back(input);
      continue;
    }
    auto stencil = stencil_of(input, direction, system);
    if (!stencil) {
      acting.without.push_back(input.key);
    } else if (beam::has_effect(*stencil)) {
      acting.stencils.push_back(std::move(*stencil));
      acting.of_beam.push_back(input);
    }
  }
  return acting;
}

std::vector<Complex> product(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  std::vector<Complex> values(a);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] *= b[k];
  return values;
}

SensitivityResult result_of(const beam::TipResponse& response) {
  SensitivityResult result;
  result.amplitude = response.amplitude();
  result.peak_velocity = response.peak_velocity();
  result.ring_down = response.ring_down();
  return result;
}

/// Largest effect first, of the same relative change of every input.
void sort_by_effect(std::vector<InputSensitivity>& inputs) {
  const auto effect = [](const InputSensitivity& input) {
    return std::abs(input.amplitude * input.value);
  };
  std::sort(inputs.begin(), inputs.end(),
            [&](const auto& a, const auto& b) { return effect(a) > effect(b); });
}

}  // namespace

SensitivityResult beam_sensitivities(const Configuration& study, const VibrationCase& setup,
                                     Direction direction) {
  if (setup.angular_frequency > 0)
    throw std::invalid_argument("sensitivities are taken of pulses, not of a sine");
  const beam::BeamSystem system = beam_of(study, setup, direction);
  const beam::SupportMotion motion = motion_of(study, setup, direction);
  const beam::Sampling sampling = study.read<BeamIntegration>().sampling();
  const std::vector<Complex> points = beam::transform_points(sampling);
  const ActingInputs acting = acting_inputs(study, setup, direction, system, motion);

  const beam::TransferSensitivity transfer =
      beam::transfer_sensitivity(system, acting.stencils, points);
  const std::vector<Complex> support = beam::laplace_transform(motion, points);
  const beam::TipResponse response(product(transfer.transfer, support), sampling,
                                   beam::kinks(motion).back().time);
  SensitivityResult result = result_of(response);
  result.without = acting.without;
  const auto add = [&](const Input& input, const std::vector<Complex>& rate, double end_rate) {
    const beam::TipResponseDerivative d = response.derivative(rate, end_rate);
    InputSensitivity sensitivity{input.key,   input.unit,      input.value,
                                 d.amplitude, d.peak_velocity, d.ring_down};
    if (direction == Direction::along) sensitivity.peak_velocity.reset();
    result.inputs.push_back(sensitivity);
  };
  for (std::size_t p = 0; p < acting.of_beam.size(); ++p)
    add(acting.of_beam[p], product(transfer.derivative[p], support), 0);
  for (std::size_t p = 0; p < acting.of_pulse.size(); ++p)
    add(acting.of_pulse[p],
        product(transfer.transfer, beam::laplace_transform_derivative(acting.kinks[p], points)),
        acting.kinks[p].back().rate.time);
  sort_by_effect(result.inputs);
  return result;
}

SensitivityResult beam_response(const Configuration& study, const VibrationCase& setup,
                                Direction direction) {
  const beam::BeamSystem system = beam_of(study, setup, direction);
  const beam::SupportMotion motion = motion_of(study, setup, direction);
  const beam::Sampling sampling = study.read<BeamIntegration>().sampling();
  const std::vector<Complex> points = beam::transform_points(sampling);
  const std::vector<Complex> tip =
      product(beam::TransferFunction(system).at(points), beam::laplace_transform(motion, points));
  return result_of(beam::TipResponse(tip, sampling, beam::kinks(motion).back().time));
}

nlohmann::json to_json(const SensitivityResult& result) {
  const auto or_null = [](const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
  };
  nlohmann::json inputs = nlohmann::json::array();
  for (const InputSensitivity& input : result.inputs)
    inputs.push_back({{"key", input.key},
                      {"unit", input.unit},
                      {"value", input.value},
                      {"amplitude", input.amplitude},
                      {"peak_velocity", or_null(input.peak_velocity)},
                      {"ring_down", or_null(input.ring_down)}});
  return {{"amplitude", result.amplitude},
          {"peak_velocity", result.peak_velocity},
          {"ring_down", or_null(result.ring_down)},
          {"inputs", inputs},
          {"without_derivative", result.without}};
}

}  // namespace zona::studies
