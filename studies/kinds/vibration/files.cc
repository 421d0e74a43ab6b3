#include "studies/kinds/vibration/files.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "studies/kinds/vibration/sensitivity.h"
#include "studies/run/history_file.h"

namespace zona::studies {

bool are_oblique(const std::vector<VibrationResult>& results) {
  return !results.empty() && results.front().axial;
}

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

void write_history(const RunDirectory& directory, const std::vector<VibrationResult>& results) {
  std::vector<Column> columns = {{"time", "s"}};
  for (const VibrationResult& result : results)
    columns.push_back(
        {fmt::format("tip {} {}", result.setup.fluid.name, result.setup.pulse_label()), "m"});
  for (const VibrationResult& result : results)
    if (result.axial)
      columns.push_back(
          {fmt::format("axial tip {} {}", result.setup.fluid.name, result.setup.pulse_label()),
           "m"});
  HistoryFile file(directory.file("history.csv"), columns);
  const std::size_t samples = results.empty() ? 0 : results.front().history.time.size();
  std::vector<double> row(columns.size());
  for (std::size_t i = 0; i < samples; ++i) {
    row[0] = results.front().history.time[i];
    std::size_t column = 1;
    for (const VibrationResult& result : results) row[column++] = result.history.displacement[i];
    for (const VibrationResult& result : results)
      if (result.axial) row[column++] = result.axial->history.displacement[i];
    file.add(row);
  }
}

void write_amplitudes(const RunDirectory& directory, const std::vector<VibrationResult>& results) {
  std::vector<Column> columns{{"fluid", ""},
                              {"fluid_density", "kg/m^3"},
                              {"pulse_duration", "s"},
                              {"angular_frequency", "rad/s"},
                              {"amplitude_ratio", ""},
                              {"peak_displacement", "m"},
                              {"time_of_peak", "s"},
                              {"peak_velocity", "m/s"},
                              {"time_of_peak_velocity", "s"},
                              {"ring_down", "s"},
                              {"residual_amplitude", "m"}};
  if (are_oblique(results))
    columns.insert(columns.end(), {{"axial_amplitude_ratio", ""},
                                   {"axial_peak_displacement", "m"},
                                   {"axial_time_of_peak", "s"}});
  HistoryFile file(directory.file("amplitudes.csv"), columns);
  for (const VibrationResult& r : results) {
    std::vector<double> row{
        r.setup.fluid.density, r.setup.pulse_duration,  r.setup.angular_frequency,
        r.amplitude_ratio,     r.peak_displacement,     r.time_of_peak,
        r.peak_velocity,       r.time_of_peak_velocity, r.ring_down,
        r.residual_amplitude};
    if (r.axial)
      row.insert(row.end(),
                 {r.axial->amplitude_ratio, r.axial->peak_displacement, r.axial->time_of_peak});
    file.add(r.setup.fluid.name, row);
  }
}

void write_sensitivities(const RunDirectory& directory,
                         const std::vector<VibrationResult>& results) {
  HistoryFile file(directory.file("sensitivities.csv"), {{"fluid; pulse; input", ""},
                                                         {"value", "SI"},
                                                         {"amplitude_elasticity", ""},
                                                         {"peak_velocity_elasticity", ""},
                                                         {"ring_down_elasticity", ""}});
  const auto add = [&](const std::string& label, const std::optional<SensitivityResult>& s) {
    if (!s) return;
    const auto elasticity = [](const std::optional<double>& rate, double value,
                               const std::optional<double>& of) {
      return rate && of && *of != 0 ? *rate * value / *of : std::nan("");
    };
    for (const InputSensitivity& input : s->inputs)
      file.add(label + "; " + input.key,
               {input.value, elasticity(input.amplitude, input.value, s->amplitude),
                elasticity(input.peak_velocity, input.value, s->peak_velocity),
                elasticity(input.ring_down, input.value, s->ring_down)});
  };
  for (const VibrationResult& r : results) {
    const std::string label = r.setup.fluid.name + "; " + r.setup.pulse_label();
    add(label, r.sensitivities);
    add(label + " along", r.axial_sensitivities);
  }
}

}  // namespace zona::studies
