#include "studies/kinds/vibration/result.h"

#include <fmt/format.h>

#include <algorithm>

namespace zona::studies {

namespace {

template <class Value>
void add_once(std::vector<Value>& values, const Value& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

std::string table_of(const std::vector<VibrationResult>& results, const std::string& title,
                     double (*ratio)(const VibrationResult&)) {
  std::vector<std::string> fluids;
  std::vector<std::string> pulses;
  for (const VibrationResult& result : results) {
    add_once(fluids, result.setup.fluid.name);
    add_once(pulses, result.setup.pulse_label());
  }
  std::string table = fmt::format("{:<16}", title);
  for (const std::string& pulse : pulses) table += fmt::format(" {:>12}", pulse);
  for (const std::string& fluid : fluids) {
    table += fmt::format("\n{:<16}", fluid);
    for (const std::string& pulse : pulses) {
      const auto cell = std::find_if(results.begin(), results.end(), [&](const auto& result) {
        return result.setup.fluid.name == fluid && result.setup.pulse_label() == pulse;
      });
      table += cell == results.end() ? fmt::format(" {:>12}", "-")
                                     : fmt::format(" {:>12.4f}", ratio(*cell));
    }
  }
  return table + "\n";
}

}  // namespace

std::string VibrationCase::pulse_label() const {
  if (angular_frequency > 0) return fmt::format("{:.6g} rad/s", angular_frequency);
  return pulse_duration > 0 ? fmt::format("{:.6g} us", pulse_duration * 1e6) : "trace";
}

bool is_oblique(const std::vector<VibrationResult>& results) {
  return !results.empty() && results.front().axial;
}

std::string amplitude_table(const std::vector<VibrationResult>& results) {
  const bool oblique = is_oblique(results);
  std::string text = table_of(results, oblique ? "across" : "amplitude ratio",
                              [](const VibrationResult& r) { return r.amplitude_ratio; });
  if (oblique)
    text += table_of(results, "along",
                     [](const VibrationResult& r) { return r.axial->amplitude_ratio; });
  return text;
}

std::string warning_text(const std::vector<VibrationResult>& results) {
  const VibrationResult* worst = nullptr;
  int count = 0;
  for (const VibrationResult& result : results) {
    if (result.warnings.empty()) continue;
    ++count;
    if (worst == nullptr || result.warnings.size() > worst->warnings.size()) worst = &result;
  }
  if (worst == nullptr) return "";
  std::string text =
      fmt::format("\n{} of {} runs leave the range of the bath's load; {}, {}:\n", count,
                  results.size(), worst->setup.fluid.name, worst->setup.pulse_label());
  for (const std::string& warning : worst->warnings) text += "- " + warning + "\n";
  return text;
}

}  // namespace zona::studies
