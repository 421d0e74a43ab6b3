#include "studies/vibration_study.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <chrono>

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>

#include "beam/natural_modes.h"
#include "studies/beam_parameters.h"
#include "studies/history_file.h"
#include "studies/interrupt.h"
#include "studies/progress.h"
#include "studies/run_directory.h"

namespace zona::studies {

namespace {

constexpr Eigen::Index kReportedFrequencies = 10;

/// A beam with everything that the cases with the same fluid share.
struct FilledPipette {
  beam::BeamSystem system;
  beam::Integrator integrator;
  std::vector<double> natural_frequencies;
};

FilledPipette fill_pipette(const Configuration& study, double density) {
  const beam::Pipette pipette = pipette_from(study, "pipette", density);
  const bool is_pinned = study.choice("pipette.supports") == "pinned";
  FilledPipette filled{is_pinned ? beam::simply_supported(pipette) : beam::cantilever(pipette),
                       integrator_from(study, "time", pipette),
                       {}};
  const Eigen::VectorXd frequency = beam::natural_modes(filled.system).frequency();
  const Eigen::Index count = std::min(frequency.size(), kReportedFrequencies);
  filled.natural_frequencies.assign(frequency.data(), frequency.data() + count);
  return filled;
}

beam::SupportMotion support_motion(const VibrationCase& setup, double peak) {
  if (setup.angular_frequency > 0) return beam::SineMotion{peak, setup.angular_frequency};
  return beam::triangular_pulse(peak, setup.pulse_duration);
}

VibrationResult compute_case(const VibrationCase& setup, const FilledPipette& pipette,
                             const beam::Sampling& sampling, double peak, bool keep_history) {
  VibrationResult result;
  result.setup = setup;
  result.natural_frequencies = pipette.natural_frequencies;
  result.history =
      integrate(pipette.system, support_motion(setup, peak), sampling, pipette.integrator);
  const beam::TipHistory& history = result.history;
  const std::size_t farthest = beam::index_of_peak(history.displacement);
  const std::size_t fastest = beam::index_of_peak(history.velocity);
  result.amplitude_ratio = beam::amplitude_ratio(history, peak);
  result.peak_displacement = history.displacement[farthest];
  result.time_of_peak = history.time[farthest];
  result.peak_velocity = history.velocity[fastest];
  result.time_of_peak_velocity = history.time[fastest];
  if (!keep_history) result.history = {};
  return result;
}

nlohmann::json to_json(const VibrationResult& result) {
  return {{"fluid", result.setup.fluid},
          {"fluid_density", result.setup.fluid_density},
          {"pulse_duration", result.setup.pulse_duration},
          {"angular_frequency", result.setup.angular_frequency},
          {"amplitude_ratio", result.amplitude_ratio},
          {"natural_frequencies", result.natural_frequencies},
          {"peak_displacement", result.peak_displacement},
          {"time_of_peak", result.time_of_peak},
          {"peak_velocity", result.peak_velocity},
          {"time_of_peak_velocity", result.time_of_peak_velocity}};
}

void write_history(const RunDirectory& directory, const std::vector<VibrationResult>& results) {
  std::vector<Column> columns = {{"time", "s"}};
  for (const VibrationResult& result : results)
    columns.push_back(
        {fmt::format("tip {} {}", result.setup.fluid, result.setup.pulse_label()), "m"});
  HistoryFile file(directory.file("history.csv"), columns);
  const std::size_t samples = results.empty() ? 0 : results.front().history.time.size();
  std::vector<double> row(columns.size());
  for (std::size_t i = 0; i < samples; ++i) {
    row[0] = results.front().history.time[i];
    for (std::size_t k = 0; k < results.size(); ++k)
      row[k + 1] = results[k].history.displacement[i];
    file.add(row);
  }
}

void write_amplitudes(const RunDirectory& directory, const std::vector<VibrationResult>& results) {
  HistoryFile file(directory.file("amplitudes.csv"), {{"fluid", ""},
                                                      {"fluid_density", "kg/m^3"},
                                                      {"pulse_duration", "s"},
                                                      {"angular_frequency", "rad/s"},
                                                      {"amplitude_ratio", ""},
                                                      {"peak_displacement", "m"},
                                                      {"time_of_peak", "s"},
                                                      {"peak_velocity", "m/s"},
                                                      {"time_of_peak_velocity", "s"}});
  for (const VibrationResult& r : results) {
    file.add(r.setup.fluid, {r.setup.fluid_density, r.setup.pulse_duration,
                             r.setup.angular_frequency, r.amplitude_ratio, r.peak_displacement,
                             r.time_of_peak, r.peak_velocity, r.time_of_peak_velocity});
  }
}

/// The values in the order in which they first occur.
template <class Value>
void add_once(std::vector<Value>& values, const Value& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

}  // namespace

std::string VibrationCase::pulse_label() const {
  return angular_frequency > 0 ? fmt::format("{:.6g} rad/s", angular_frequency)
                               : fmt::format("{:.6g} us", pulse_duration * 1e6);
}

std::vector<VibrationCase> vibration_cases(const Configuration& study) {
  const std::vector<double> densities = study.quantities("fill.fluids");
  const std::vector<std::string> names = study.texts("fill.fluids");
  const bool is_sine = study.choice("pulse.shape") == "sine";
  const char* pulses = is_sine ? "pulse.angular_frequencies" : "pulse.durations";
  std::vector<VibrationCase> cases;
  for (std::size_t fluid = 0; fluid < densities.size(); ++fluid)
    for (const double pulse : study.quantities(pulses))
      cases.push_back({names[fluid], densities[fluid], is_sine ? 0 : pulse, is_sine ? pulse : 0});
  return cases;
}

std::vector<VibrationResult> compute_vibration(const Configuration& study, Session& session) {
  const std::vector<VibrationCase> cases = vibration_cases(study);
  std::vector<FilledPipette> pipettes;
  for (const double density : study.quantities("fill.fluids"))
    pipettes.push_back(fill_pipette(study, density));
  const std::size_t pulses = cases.size() / pipettes.size();
  const beam::Sampling sampling = sampling_from(study, "time");
  const double peak = study.quantity("pulse.peak");
  const bool keep_history = study.boolean("output.history");

  std::vector<std::optional<VibrationResult>> slots(cases.size());
  std::vector<std::exception_ptr> failures(cases.size());
  int done = 0;
  session.progress.start("vibration", static_cast<double>(cases.size()));
#pragma omp parallel for schedule(dynamic) num_threads(session.threads)
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (Interrupt::requested()) continue;
    try {
      slots[i] = compute_case(cases[i], pipettes[i / pulses], sampling, peak, keep_history);
    } catch (...) {
      failures[i] = std::current_exception();
    }
#pragma omp critical(zona_vibration_progress)
    session.progress.update(++done, 0, cases[i].fluid + ", " + cases[i].pulse_label());
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  session.progress.finish();
  std::vector<VibrationResult> results;
  for (auto& slot : slots)
    if (slot) results.push_back(std::move(*slot));
  return results;
}

std::string amplitude_table(const std::vector<VibrationResult>& results) {
  std::vector<std::string> fluids;
  std::vector<std::string> pulses;
  for (const VibrationResult& result : results) {
    add_once(fluids, result.setup.fluid);
    add_once(pulses, result.setup.pulse_label());
  }
  std::string table = fmt::format("{:<16}", "amplitude ratio");
  for (const std::string& pulse : pulses) table += fmt::format(" {:>12}", pulse);
  for (const std::string& fluid : fluids) {
    table += fmt::format("\n{:<16}", fluid);
    for (const std::string& pulse : pulses) {
      const auto cell = std::find_if(results.begin(), results.end(), [&](const auto& result) {
        return result.setup.fluid == fluid && result.setup.pulse_label() == pulse;
      });
      table += cell == results.end() ? fmt::format(" {:>12}", "-")
                                     : fmt::format(" {:>12.4f}", cell->amplitude_ratio);
    }
  }
  return table + "\n";
}

Job prepare_vibration(const Configuration& study) {
  for (double density : study.quantities("fill.fluids")) pipette_from(study, "pipette", density);
  return [study, keep_history = study.boolean("output.history")](Session& session) {
    const std::vector<VibrationResult> results = compute_vibration(study, session);
    session.results = nlohmann::json::array();
    for (const VibrationResult& result : results) session.results.push_back(to_json(result));
    write_amplitudes(session.directory, results);
    if (keep_history) write_history(session.directory, results);
    const std::string table = amplitude_table(results);
    session.directory.log().info("greatest tip displacement over peak support displacement\n" +
                                 table);
    session.conclusion = table;
  };
}

StudyCost estimate_vibration(const Configuration& study) {
  const beam::Sampling sampling = sampling_from(study, "time");
  return {fmt::format("{} runs of {} samples with {} beam elements, by {}",
                      vibration_cases(study).size(), beam::sample_count(sampling),
                      study.integer("pipette.elements"), study.choice("time.integrator"))};
}

std::string try_vibration(const Configuration& study, int threads) {
  using Clock = std::chrono::steady_clock;
  const auto cases = vibration_cases(study);
  const auto begin = Clock::now();
  fill_pipette(study, cases.front().fluid_density);  // loads deal.II, once
  const auto start = Clock::now();
  const FilledPipette pipette = fill_pipette(study, cases.front().fluid_density);
  const auto filled = Clock::now();
  compute_case(cases.front(), pipette, sampling_from(study, "time"), study.quantity("pulse.peak"),
               false);
  const std::chrono::duration<double> load = start - begin, fill = filled - start,
                                      one = Clock::now() - filled;
  const double fills = static_cast<double>(study.quantities("fill.fluids").size());
  const double all = static_cast<double>(cases.size()) / threads;
  return fmt::format("Here, from trying one on a thread of {}: about {}\n", threads,
                     duration_text(load.count() + fills * fill.count() + all * one.count()));
}

}  // namespace zona::studies
