#include "studies/kinds/vibration/files.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "studies/kinds/vibration/sensitivity.h"
#include "studies/run/history_file.h"

namespace zona::studies {

nlohmann::json to_json(const VibrationResult& result) {
  nlohmann::json json = {
      {"fluid", result.setup.fluid.name},
      {"fluid_density", result.setup.fluid.density},
      {"pulse_duration", result.setup.pulse_duration},
      {"angular_frequency", result.setup.angular_frequency},
      {"amplitude_ratio", result.amplitude_ratio},
      {"natural_frequencies", result.natural_frequencies},
      {"peak_displacement", result.peak_displacement},
      {"time_of_peak", result.time_of_peak},
      {"peak_velocity", result.peak_velocity},
      {"time_of_peak_velocity", result.time_of_peak_velocity},
      {"damping_ratios", result.damping_ratios},
      {"ring_down",
       std::isfinite(result.ring_down) ? nlohmann::json(result.ring_down) : nlohmann::json()},
      {"residual_amplitude", result.residual_amplitude},
      {"warnings", result.warnings}};
  if (result.gain_uncertainty > 0) {
    const double peak = std::abs(result.peak_displacement);
    json["peak_displacement_range"] = {peak * (1 - result.gain_uncertainty),
                                       peak * (1 + result.gain_uncertainty)};
  }
  if (result.axial) {
    json["axial_amplitude_ratio"] = result.axial->amplitude_ratio;
    json["axial_peak_displacement"] = result.axial->peak_displacement;
    json["axial_time_of_peak"] = result.axial->time_of_peak;
  }
  if (result.sensitivities) json["sensitivities"] = to_json(*result.sensitivities);
  if (result.axial_sensitivities)
    json["axial_sensitivities"] = to_json(*result.axial_sensitivities);
  return json;
}

namespace {

/// A column per case with the tip's displacement at a sample, of the history that `of` picks.
template <class Of>
void add_displacements(std::vector<ValueColumn<std::size_t>>& columns, const std::string& title,
                       const std::vector<VibrationResult>& results, const Of& of) {
  for (const VibrationResult& result : results) {
    if (const beam::TipHistory* history = of(result))
      columns.push_back(
          {fmt::format("{} {} {}", title, result.setup.fluid.name, result.setup.pulse_label()), "m",
           [history](std::size_t i) { return history->displacement[i]; }});
  }
}

}  // namespace

void write_history(const RunDirectory& directory, const std::vector<VibrationResult>& results) {
  std::vector<ValueColumn<std::size_t>> columns = {
      {"time", "s", [&](std::size_t i) { return results.front().history.time[i]; }}};
  add_displacements(columns, "tip", results, [](const VibrationResult& r) { return &r.history; });
  add_displacements(columns, "axial tip", results,
                    [](const VibrationResult& r) { return r.axial ? &r.axial->history : nullptr; });
  HistoryFile file(directory.file("history.csv"), headings(columns));
  const std::size_t samples = results.empty() ? 0 : results.front().history.time.size();
  for (std::size_t i = 0; i < samples; ++i) file.add(row_of(columns, i));
}

void write_amplitudes(const RunDirectory& directory, const std::vector<VibrationResult>& results) {
  using Result = VibrationResult;
  std::vector<ValueColumn<Result>> columns{
      {"fluid_density", "kg/m^3", [](const Result& r) { return r.setup.fluid.density; }},
      {"pulse_duration", "s", [](const Result& r) { return r.setup.pulse_duration; }},
      {"angular_frequency", "rad/s", [](const Result& r) { return r.setup.angular_frequency; }},
      {"amplitude_ratio", "", [](const Result& r) { return r.amplitude_ratio; }},
      {"peak_displacement", "m", [](const Result& r) { return r.peak_displacement; }},
      {"time_of_peak", "s", [](const Result& r) { return r.time_of_peak; }},
      {"peak_velocity", "m/s", [](const Result& r) { return r.peak_velocity; }},
      {"time_of_peak_velocity", "s", [](const Result& r) { return r.time_of_peak_velocity; }},
      {"ring_down", "s", [](const Result& r) { return r.ring_down; }},
      {"residual_amplitude", "m", [](const Result& r) { return r.residual_amplitude; }}};
  if (is_oblique(results)) {
    columns.insert(
        columns.end(),
        {{"axial_amplitude_ratio", "", [](const Result& r) { return r.axial->amplitude_ratio; }},
         {"axial_peak_displacement", "m",
          [](const Result& r) { return r.axial->peak_displacement; }},
         {"axial_time_of_peak", "s", [](const Result& r) { return r.axial->time_of_peak; }}});
  }
  HistoryFile file(directory.file("amplitudes.csv"), headings(columns, {{"fluid", ""}}));
  for (const Result& result : results) file.add(result.setup.fluid.name, row_of(columns, result));
}

namespace {

/// Relative change of a response per relative change of an input; NaN where it is unknown.
double elasticity(const std::optional<double>& derivative, double input,
                  const std::optional<double>& response) {
  const bool is_known = derivative && response && *response != 0;
  return is_known ? *derivative * input / *response : std::nan("");
}

}  // namespace

void write_sensitivities(const RunDirectory& directory,
                         const std::vector<VibrationResult>& results) {
  using Response = SensitivityResult;
  using Input = InputSensitivity;
  const std::vector<ValueColumn<Response, Input>> columns{
      {"value", "SI", [](const Response&, const Input& i) { return i.value; }},
      {"amplitude_elasticity", "",
       [](const Response& r, const Input& i) {
         return elasticity(i.amplitude, i.value, r.amplitude);
       }},
      {"peak_velocity_elasticity", "",
       [](const Response& r, const Input& i) {
         return elasticity(i.peak_velocity, i.value, r.peak_velocity);
       }},
      {"ring_down_elasticity", "", [](const Response& r, const Input& i) {
         return elasticity(i.ring_down, i.value, r.ring_down);
       }}};
  HistoryFile file(directory.file("sensitivities.csv"),
                   headings(columns, {{"fluid; pulse; input", ""}}));
  const auto add = [&](const std::string& label, const std::optional<Response>& response) {
    if (!response) return;
    for (const Input& input : response->inputs)
      file.add(label + "; " + input.key, row_of(columns, *response, input));
  };
  for (const VibrationResult& r : results) {
    const std::string label = r.setup.fluid.name + "; " + r.setup.pulse_label();
    add(label, r.sensitivities);
    add(label + " along", r.axial_sensitivities);
  }
}

}  // namespace zona::studies
