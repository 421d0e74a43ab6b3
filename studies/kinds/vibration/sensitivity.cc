#include "studies/kinds/vibration/sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

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

/// Of an input, relative. Its fourth power is the error of what is not a polynomial in the input.
constexpr double kStep = 2.5e-4;
constexpr std::array<double, 4> kPlaces{-2, -1, 1, 2};
constexpr std::array<double, 4> kStencil{1. / 12, -8. / 12, 8. / 12, -1. / 12};

/// An input, and the study and case that result when it is multiplied by a factor.
struct Input {
  std::string key;
  std::string unit;
  double value;
  bool moves_support;  ///< whether it belongs to the pulse
  std::function<std::pair<Configuration, VibrationCase>(double factor)> times;
};

Configuration scaled(const Configuration& study, const std::string& key, double factor) {
  Configuration moved = study;
  Setting setting = study.setting(key);
  for (double& number : setting.numbers) number *= factor;
  moved.set(key, setting);
  return moved;
}

/// Quantities and numbers that stand alone in the tables that describe pipette and pulse.
std::vector<Input> inputs_of(const Configuration& study, const VibrationCase& setup) {
  std::vector<Input> inputs;
  const bool moves_along = study.read<Pulse>().direction().along != 0;
  const std::string pulse = study.schema().binding<Pulse>().section;
  const auto add = [&](const std::string& key) {
    // At a right angle there is no motion along the pipette for the angle to trade with; the
    // fluid's viscosity is the case's.
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
  const auto add_own = [&](const std::string& key, const char* unit, bool moves_support,
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
  add_own(study.key(&Fills::fluids), "kg/m^3", false,
          [](VibrationCase& c) -> double& { return c.fluid.density; });
  add_own(study.key(&FillPlace::viscosity), "Pa s", false,
          [](VibrationCase& c) -> double& { return c.fluid.viscosity; });
  add_own(study.key(&Pulses::durations), "s", true,
          [](VibrationCase& c) -> double& { return c.pulse_duration; });
  return inputs;
}

beam::BeamSystem beam_of(const Configuration& study, const VibrationCase& setup,
                         Direction direction) {
  const beam::Pipette pipette = pipette_from(study, setup.fluid);
  if (direction == Direction::along) return beam::axial_rod(pipette);
  return study.value(&Support::supports) == Supports::pinned ? beam::simply_supported(pipette)
                                                             : beam::cantilever(pipette);
}

/// The support's motion in a direction.
beam::SupportMotion motion_of(const Configuration& study, const VibrationCase& setup,
                              Direction direction) {
  const beam::SupportMotion motion = support_motion(study, setup.pulse_duration);
  const PulseDirection parts = study.read<Pulse>().direction();
  const double part = direction == Direction::across ? parts.across : parts.along;
  return part == 1 ? motion : beam::scaled(motion, part);
}

/// The beam with an input moved; nothing where it has another mesh then.
std::optional<beam::ParameterStencil> stencil_of(const Input& input, Direction direction,
                                                 const beam::BeamSystem& system) {
  beam::ParameterStencil stencil;
  stencil.step = kStep * input.value;
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const auto [study, setup] = input.times(1 + kPlaces[i] * kStep);
    stencil.moved[i] = beam_of(study, setup, direction);
    if (stencil.moved[i].size() != system.size() ||
        stencil.moved[i].liquids.viscous.size() != system.liquids.viscous.size())
      return std::nullopt;
  }
  return stencil;
}

bool changes(const beam::ParameterStencil& stencil) {
  const auto differ = [](const beam::SymmetricBand& a, const beam::SymmetricBand& b) {
    for (int k = 0; k <= beam::kHalfBandwidth; ++k)
      if (a.diagonal(k) != b.diagonal(k)) return true;
    return false;
  };
  const beam::BeamSystem& a = stencil.moved.front();
  const beam::BeamSystem& b = stencil.moved.back();
  return differ(a.mass, b.mass) || differ(a.stiffness, b.stiffness) || !same_factors(a, b) ||
         (a.liquids.act() && differ(a.liquids.displaced.matrix, b.liquids.displaced.matrix));
}

/// Derivatives of the kinks' times and jumps, of which the motion's transform is made.
std::vector<std::pair<beam::Kink, beam::Kink>> moving_kinks(const Input& input, Direction direction,
                                                            const beam::SupportMotion& motion) {
  std::vector<std::pair<beam::Kink, beam::Kink>> kinks;
  for (const beam::Kink& kink : beam::kinks(motion)) kinks.emplace_back(kink, beam::Kink{});
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const auto [study, setup] = input.times(1 + kPlaces[i] * kStep);
    const auto moved = beam::kinks(motion_of(study, setup, direction));
    if (moved.size() != kinks.size()) return {};
    const double weight = kStencil[i] / (kStep * input.value);
    for (std::size_t k = 0; k < kinks.size(); ++k) {
      kinks[k].second.time += weight * moved[k].time;
      kinks[k].second.velocity_jump += weight * moved[k].velocity_jump;
    }
  }
  return kinks;
}

/// Derivative of sum J exp(-s t) / s^2.
Complex transform_derivative(const std::vector<std::pair<beam::Kink, beam::Kink>>& kinks,
                             Complex s) {
  Complex sum = 0;
  for (const auto& [kink, rate] : kinks)
    sum += (rate.velocity_jump - s * rate.time * kink.velocity_jump) * std::exp(-s * kink.time);
  return sum / (s * s);
}

/// A place between samples: index of the sample before and the share of the interval.
struct Place {
  std::size_t sample = 0;
  double share = 0;

  double of(const std::vector<double>& values) const {
    if (sample + 1 >= values.size()) return values.back();
    return (1 - share) * values[sample] + share * values[sample + 1];
  }
};

/// Where `slope` passes zero next to the greatest magnitude of `values`.
Place place_of_peak(const std::vector<double>& values, const std::vector<double>& slope) {
  const std::size_t peak = beam::index_of_peak(values);
  for (const std::size_t first : {peak == 0 ? peak : peak - 1, peak}) {
    if (first + 1 >= values.size() || slope[first] * slope[first + 1] > 0) continue;
    const double span = slope[first] - slope[first + 1];
    return {first, span == 0 ? 0 : slope[first] / span};
  }
  return {peak, 0};
}

/// A value at a place where its derivative is known at the samples, to third order.
double hermite(const Place& place, const std::vector<double>& values,
               const std::vector<double>& slope, double step) {
  if (place.sample + 1 >= values.size()) return values.back();
  const double x = place.share;
  const double a = values[place.sample], b = values[place.sample + 1];
  const double da = step * slope[place.sample], db = step * slope[place.sample + 1];
  return a * (1 + 2 * x) * (1 - x) * (1 - x) + da * x * (1 - x) * (1 - x) +
         b * x * x * (3 - 2 * x) - db * x * x * (1 - x);
}

/// Last instant at which the magnitude falls through the limit; nothing if it never stays below.
std::optional<Place> last_crossing(const std::vector<double>& values, double limit) {
  std::size_t last = values.size();
  while (last > 0 && std::abs(values[last - 1]) <= limit) --last;
  if (last == 0 || last == values.size()) return std::nullopt;
  const double above = std::abs(values[last - 1]), below = std::abs(values[last]);
  return Place{last - 1, (above - limit) / (above - below)};
}

/// The response and how it is derived.
class Response {
 public:
  Response(std::vector<Complex> transform, const std::vector<Complex>& points,
           const beam::Sampling& sampling, double pulse_end)
      : sampling_(sampling), points_(points) {
    displacement_ = beam::invert_transform(sampling, transform);
    velocity_ = derivative(transform);
    for (std::size_t k = 0; k < points.size(); ++k) transform[k] *= points[k];
    acceleration_ = derivative(transform);
    farthest_ = place_of_peak(displacement_, velocity_);
    fastest_ = place_of_peak(velocity_, acceleration_);
    amplitude_ = hermite(farthest_, displacement_, velocity_, sampling.step);
    peak_velocity_ = hermite(fastest_, velocity_, acceleration_, sampling.step);
    still_ = last_crossing(displacement_, 0.1 * std::abs(amplitude_));
    pulse_end_ = pulse_end;
  }

  void report(SensitivityResult& result) const {
    result.amplitude = std::abs(amplitude_);
    result.peak_velocity = std::abs(peak_velocity_);
    if (still_)
      result.ring_down =
          (static_cast<double>(still_->sample) + still_->share) * sampling_.step - pulse_end_;
  }

  /// `pulse_end_rate` is how the end of the pulse moves with the input.
  void derive(std::vector<Complex> transform, double pulse_end_rate,
              InputSensitivity& input) const {
    const std::vector<double> displacement = beam::invert_transform(sampling_, transform);
    const std::vector<double> velocity = derivative(transform);
    for (std::size_t k = 0; k < transform.size(); ++k) transform[k] *= points_[k];
    const std::vector<double> acceleration = derivative(transform);
    // Where the response is greatest its own change in time does not count.
    input.amplitude = sign(amplitude_) * hermite(farthest_, displacement, velocity, sampling_.step);
    input.peak_velocity =
        sign(peak_velocity_) * hermite(fastest_, velocity, acceleration, sampling_.step);
    if (!still_) return;
    const double side = sign(still_->of(displacement_));
    input.ring_down =
        (0.1 * input.amplitude - side * still_->of(displacement)) / (side * still_->of(velocity_)) -
        pulse_end_rate;
  }

 private:
  static double sign(double value) { return value < 0 ? -1 : 1; }

  std::vector<double> derivative(const std::vector<Complex>& transform) const {
    std::vector<Complex> product(transform);
    for (std::size_t k = 0; k < product.size(); ++k) product[k] *= points_[k];
    return beam::invert_transform(sampling_, product);
  }

  beam::Sampling sampling_;
  const std::vector<Complex>& points_;
  std::vector<double> displacement_, velocity_, acceleration_;
  Place farthest_, fastest_;
  std::optional<Place> still_;
  double amplitude_ = 0, peak_velocity_ = 0, pulse_end_ = 0;
};

}  // namespace

SensitivityResult beam_sensitivities(const Configuration& study, const VibrationCase& setup,
                                     Direction direction) {
  if (setup.angular_frequency > 0)
    throw std::invalid_argument("sensitivities are taken of pulses, not of a sine");
  const beam::BeamSystem system = beam_of(study, setup, direction);
  const beam::SupportMotion motion = motion_of(study, setup, direction);
  const beam::Sampling sampling = study.read<BeamIntegration>().sampling();
  const std::vector<Complex> points = beam::transform_points(sampling);

  SensitivityResult result;
  std::vector<Input> of_beam, of_pulse;
  std::vector<beam::ParameterStencil> stencils;
  std::vector<std::vector<std::pair<beam::Kink, beam::Kink>>> kinks;
  for (const Input& input : inputs_of(study, setup)) {
    if (input.moves_support) {
      const auto moving = moving_kinks(input, direction, motion);
      const bool acts = std::any_of(moving.begin(), moving.end(), [&](const auto& kink) {
        const auto& [at, rate] = kink;
        constexpr double rounding = 1e-9;
        return std::abs(rate.time * input.value) > rounding * moving.back().first.time ||
               std::abs(rate.velocity_jump * input.value) > rounding * std::abs(at.velocity_jump);
      });
      if (moving.empty()) result.without.push_back(input.key);
      if (!acts) continue;
      kinks.push_back(moving);
      of_pulse.push_back(input);
      continue;
    }
    auto stencil = stencil_of(input, direction, system);
    if (!stencil) {
      result.without.push_back(input.key);
    } else if (changes(*stencil)) {
      stencils.push_back(std::move(*stencil));
      of_beam.push_back(input);
    }
  }

  const beam::TransferSensitivity transfer = beam::transfer_sensitivity(system, stencils, points);
  const std::vector<Complex> support = beam::laplace_transform(motion, points);
  std::vector<Complex> tip(transfer.transfer);
  for (std::size_t k = 0; k < points.size(); ++k) tip[k] *= support[k];
  const double pulse_end = beam::kinks(motion).back().time;
  const Response response(tip, points, sampling, pulse_end);
  response.report(result);
  const auto add = [&](const Input& input, const std::vector<Complex>& rate, double end_rate) {
    InputSensitivity sensitivity{input.key, input.unit, input.value, 0, {}, {}};
    response.derive(rate, end_rate, sensitivity);
    if (direction == Direction::along) sensitivity.peak_velocity.reset();
    result.inputs.push_back(sensitivity);
  };
  for (std::size_t p = 0; p < of_beam.size(); ++p) {
    std::vector<Complex> rate(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      rate[k] = transfer.derivative[p][k] * support[k];
    add(of_beam[p], rate, 0);
  }
  for (std::size_t p = 0; p < of_pulse.size(); ++p) {
    std::vector<Complex> rate(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      rate[k] = transfer.transfer[k] * transform_derivative(kinks[p], points[k]);
    add(of_pulse[p], rate, kinks[p].back().second.time);
  }
  const auto weight = [&](const InputSensitivity& input) {
    return std::abs(input.amplitude * input.value);
  };
  std::sort(result.inputs.begin(), result.inputs.end(),
            [&](const auto& a, const auto& b) { return weight(a) > weight(b); });
  return result;
}

SensitivityResult beam_response(const Configuration& study, const VibrationCase& setup,
                                Direction direction) {
  const beam::BeamSystem system = beam_of(study, setup, direction);
  const beam::SupportMotion motion = motion_of(study, setup, direction);
  const beam::Sampling sampling = study.read<BeamIntegration>().sampling();
  const std::vector<Complex> points = beam::transform_points(sampling);
  std::vector<Complex> tip = beam::TransferFunction(system).at(points);
  const std::vector<Complex> support = beam::laplace_transform(motion, points);
  for (std::size_t k = 0; k < points.size(); ++k) tip[k] *= support[k];
  SensitivityResult result;
  Response(tip, points, sampling, beam::kinks(motion).back().time).report(result);
  return result;
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
