#include "studies/kinds/vibration/study.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <chrono>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "beam/frequency/transfer_function.h"
#include "beam/system/natural_modes.h"
#include "beam/time/modal_stepper.h"
#include "studies/kinds/vibration/files.h"
#include "studies/kinds/vibration/sensitivity.h"
#include "studies/parameters/beam_parameters.h"
#include "studies/parameters/shared_parameters.h"
#include "studies/run/interrupt.h"
#include "studies/run/progress.h"
#include "studies/run/run_directory.h"

namespace zona::studies {

namespace {

constexpr Eigen::Index kReportedFrequencies = 10;

/// A beam with everything that the cases with the same fluid share.
struct FilledPipette {
  beam::BeamSystem system;
  beam::Integrator integrator;
  std::vector<double> natural_frequencies{};
  std::vector<double> damping_ratios{};
  /// At beam::transform_points; empty but for the integrator "transform".
  std::vector<std::complex<double>> transfer{};
  /// Only where the support moves along the pipette, too.
  std::optional<beam::BeamSystem> rod{};
};

FilledPipette fill_pipette(const Configuration& study, const beam::Fluid& fluid) {
  const beam::Pipette pipette = pipette_from(study, "pipette", fluid);
  const bool is_pinned = study.choice("pipette.supports") == "pinned";
  FilledPipette filled;
  filled.system = is_pinned ? beam::simply_supported(pipette) : beam::cantilever(pipette);
  filled.integrator = integrator_from(study, "time", filled.system);
  const beam::NaturalModes modes = beam::natural_modes(filled.system);
  const Eigen::Index count = std::min(modes.angular_frequency.size(), kReportedFrequencies);
  const beam::ModalOscillators lowest =
      beam::oscillators(filled.system, modes, static_cast<int>(count));
  for (Eigen::Index n = 0; n < count; ++n) {
    filled.natural_frequencies.push_back(lowest.angular_frequency(n) / (2 * M_PI));
    filled.damping_ratios.push_back(lowest.decay_rate(n) / lowest.angular_frequency(n));
  }
  if (std::holds_alternative<beam::Transform>(filled.integrator)) {
    filled.transfer = beam::TransferFunction(filled.system)
                          .at(beam::transform_points(sampling_from(study, "time")));
  }
  if (pulse_direction(study).along != 0) filled.rod = beam::axial_rod(pipette);
  return filled;
}

beam::SupportMotion motion_of(const VibrationCase& setup, const Configuration& study) {
  if (setup.angular_frequency > 0)
    return beam::SineMotion{support_peak(study), setup.angular_frequency};
  return support_motion(study, setup.pulse_duration);
}

/// When a motion of straight pieces is at rest for good [s]; 0 for a sine.
double end_of_pulse(const beam::SupportMotion& motion) {
  const auto* pieces = std::get_if<beam::SampledMotion>(&motion);
  return pieces == nullptr ? 0 : pieces->time.back();
}

double ring_down(const beam::TipHistory& history, double pulse_end) {
  const double limit =
      0.1 * std::abs(history.displacement[beam::index_of_peak(history.displacement)]);
  std::size_t last = history.time.size();
  while (last > 0 && std::abs(history.displacement[last - 1]) <= limit) --last;
  if (last == history.time.size()) return std::numeric_limits<double>::infinity();
  return std::max(0., history.time[last] - pulse_end);
}

double residual_amplitude(const beam::TipHistory& history) {
  double greatest = 0;
  for (std::size_t i = history.time.size() * 9 / 10; i < history.time.size(); ++i)
    greatest = std::max(greatest, std::abs(history.displacement[i]));
  return greatest;
}

AxialResult axial_result(beam::TipHistory history, double support_peak) {
  const std::size_t farthest = beam::index_of_peak(history.displacement);
  return {beam::amplitude_ratio(history, support_peak), history.displacement[farthest],
          history.time[farthest], std::move(history)};
}

VibrationResult compute_case(const VibrationCase& setup, const FilledPipette& pipette,
                             const beam::Sampling& sampling, const Configuration& study) {
  VibrationResult result;
  result.setup = setup;
  result.natural_frequencies = pipette.natural_frequencies;
  result.damping_ratios = pipette.damping_ratios;
  const beam::SupportMotion support = motion_of(setup, study);
  const PulseDirection part = pulse_direction(study);
  const beam::SupportMotion motion = part.along == 0 ? support : beam::scaled(support, part.across);
  const double peak = beam::peak_displacement(support);
  result.history = pipette.transfer.empty()
                       ? integrate(pipette.system, motion, sampling, pipette.integrator)
                       : beam::history_by_transform(pipette.transfer, motion, sampling);
  const beam::TipHistory& history = result.history;
  const std::size_t farthest = beam::index_of_peak(history.displacement);
  const std::size_t fastest = beam::index_of_peak(history.velocity);
  result.amplitude_ratio = beam::amplitude_ratio(history, peak);
  result.peak_displacement = history.displacement[farthest];
  result.time_of_peak = history.time[farthest];
  result.peak_velocity = history.velocity[fastest];
  result.time_of_peak_velocity = history.time[fastest];
  // Without a quadratic drag the tip's motion is proportional to the support's.
  if (study.is_auto("pulse.peak") && study.number("bath.drag_coefficient") == 0)
    result.gain_uncertainty = study.number("pulse.gain_uncertainty");
  result.ring_down = ring_down(history, end_of_pulse(motion));
  result.residual_amplitude = residual_amplitude(history);
  result.warnings = bath_warnings(study, "pipette", history);
  if (pipette.rod)
    result.axial = axial_result(integrate(*pipette.rod, beam::scaled(support, part.along), sampling,
                                          integrator_from(study, "time", *pipette.rod)),
                                peak);
  if (study.boolean("output.sensitivities")) {
    if (part.across != 0) result.sensitivities = beam_sensitivities(study, setup);
    if (part.along != 0)
      result.axial_sensitivities = beam_sensitivities(study, setup, Direction::along);
  }
  if (!study.boolean("output.history")) {
    result.history = {};
    if (result.axial) result.axial->history = {};
  }
  return result;
}

/// The values in the order in which they first occur.
template <class Value>
void add_once(std::vector<Value>& values, const Value& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

}  // namespace

std::string VibrationCase::pulse_label() const {
  if (angular_frequency > 0) return fmt::format("{:.6g} rad/s", angular_frequency);
  return pulse_duration > 0 ? fmt::format("{:.6g} us", pulse_duration * 1e6) : "trace";
}

std::vector<VibrationCase> vibration_cases(const Configuration& study) {
  const std::string& shape = study.choice("pulse.shape");
  const bool is_sine = shape == "sine";
  const char* key = is_sine ? "pulse.angular_frequencies" : "pulse.durations";
  const auto pulses = shape == "trace" ? std::vector<double>{0} : study.quantities(key);
  std::vector<VibrationCase> cases;
  for (const beam::Fluid& fluid : fills_of(study))
    for (const double pulse : pulses)
      cases.push_back({fluid, is_sine ? 0 : pulse, is_sine ? pulse : 0});
  return cases;
}

std::vector<VibrationResult> compute_vibration(const Configuration& study, Session& session) {
  const std::vector<VibrationCase> cases = vibration_cases(study);
  const std::vector<beam::Fluid> fills = fills_of(study);
  std::vector<FilledPipette> pipettes(fills.size());
  pipettes.front() = fill_pipette(study, fills.front());  // loads deal.II, once
  std::vector<std::exception_ptr> refusals(fills.size());
#pragma omp parallel for schedule(dynamic) num_threads(session.threads)
  for (std::size_t i = 1; i < fills.size(); ++i) {
    if (Interrupt::requested()) continue;
    try {
      pipettes[i] = fill_pipette(study, fills[i]);
    } catch (...) {
      refusals[i] = std::current_exception();
    }
  }
  for (const std::exception_ptr& refusal : refusals)
    if (refusal) std::rethrow_exception(refusal);
  const std::size_t pulses = cases.size() / pipettes.size();
  const beam::Sampling sampling = sampling_from(study, "time");

  std::vector<std::optional<VibrationResult>> slots(cases.size());
  std::vector<std::exception_ptr> failures(cases.size());
  int done = 0;
  session.progress.start("vibration", static_cast<double>(cases.size()));
#pragma omp parallel for schedule(dynamic) num_threads(session.threads)
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (Interrupt::requested()) continue;
    try {
      slots[i] = compute_case(cases[i], pipettes[i / pulses], sampling, study);
    } catch (...) {
      failures[i] = std::current_exception();
    }
#pragma omp critical(zona_vibration_progress)
    session.progress.update(++done, 0, cases[i].fluid.name + ", " + cases[i].pulse_label());
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  session.progress.finish();
  std::vector<VibrationResult> results;
  for (auto& slot : slots)
    if (slot) results.push_back(std::move(*slot));
  return results;
}

namespace {

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

std::string amplitude_table(const std::vector<VibrationResult>& results) {
  const bool oblique = are_oblique(results);
  std::string text = table_of(results, oblique ? "across" : "amplitude ratio",
                              [](const VibrationResult& r) { return r.amplitude_ratio; });
  if (oblique)
    text += table_of(results, "along",
                     [](const VibrationResult& r) { return r.axial->amplitude_ratio; });
  return text;
}

namespace {

/// The warnings of the case that has most of them, and how many cases have any.
std::string warnings_of(const std::vector<VibrationResult>& results) {
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

}  // namespace

Job prepare_vibration(const Configuration& study) {
  for (const beam::Fluid& fluid : fills_of(study)) pipette_from(study, "pipette", fluid);
  for (const VibrationCase& setup : vibration_cases(study)) motion_of(setup, study);
  return [study, keep_history = study.boolean("output.history")](Session& session) {
    const std::vector<VibrationResult> results = compute_vibration(study, session);
    session.results = nlohmann::json::array();
    for (const VibrationResult& result : results) session.results.push_back(to_json(result));
    write_amplitudes(session.directory, results);
    if (keep_history) write_history(session.directory, results);
    if (study.boolean("output.sensitivities")) write_sensitivities(session.directory, results);
    const std::string table =
        amplitude_table(results) + calibration_text(study) + warnings_of(results);
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
  fill_pipette(study, cases.front().fluid);  // loads deal.II, once
  const auto start = Clock::now();
  const FilledPipette pipette = fill_pipette(study, cases.front().fluid);
  const auto filled = Clock::now();
  compute_case(cases.front(), pipette, sampling_from(study, "time"), study);
  const std::chrono::duration<double> load = start - begin, fill = filled - start,
                                      one = Clock::now() - filled;
  const double fills = static_cast<double>(study.quantities("fill.fluids").size());
  const double all = static_cast<double>(cases.size()) / threads;
  return fmt::format("Here, from trying one on a thread of {}: about {}\n", threads,
                     duration_text(load.count() + fills * fill.count() + all * one.count()));
}

}  // namespace zona::studies
