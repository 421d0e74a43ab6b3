#include "studies/kinds/vibration/study.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>

#include "studies/kinds/vibration/case.h"
#include "studies/kinds/vibration/files.h"
#include "studies/kinds/vibration/pulses_table.h"
#include "studies/parameters/bath_table.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/beam_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pipette_model.h"
#include "studies/parameters/pulse_table.h"
#include "studies/run/interrupt.h"
#include "studies/run/parallel.h"
#include "studies/run/progress.h"
#include "studies/run/run_directory.h"

namespace zona::studies {

namespace {

/// The first one alone: it loads deal.II, once.
std::vector<FilledPipette> fill_pipettes(const Configuration& study, int threads) {
  const std::vector<beam::Fluid> fills = fills_of(study);
  std::vector<FilledPipette> pipettes(fills.size());
  pipettes.front() = fill_pipette(study, fills.front());
  parallel_for(fills.size() - 1, {threads, 1}, [&](std::size_t i) {
    if (!Interrupt::requested()) pipettes[i + 1] = fill_pipette(study, fills[i + 1]);
  });
  return pipettes;
}

}  // namespace

std::vector<VibrationResult> compute_vibration(const Configuration& study, Session& session) {
  const std::vector<VibrationCase> cases = vibration_cases(study);
  const std::vector<FilledPipette> pipettes = fill_pipettes(study, session.threads);
  const std::size_t pulses = cases.size() / pipettes.size();
  const beam::Sampling sampling = study.read<BeamIntegration>().sampling();
  std::vector<std::optional<VibrationResult>> slots(cases.size());
  parallel_stage("vibration", cases.size(), session.threads, session.progress, [&](std::size_t i) {
    slots[i] = compute_case(cases[i], pipettes[i / pulses], sampling, study);
    return cases[i].fluid.name + ", " + cases[i].pulse_label();
  });
  std::vector<VibrationResult> results;
  for (auto& slot : slots)
    if (slot) results.push_back(std::move(*slot));
  return results;
}

Job prepare_vibration(const Configuration& study) {
  for (const beam::Fluid& fluid : fills_of(study)) pipette_from(study, fluid);
  for (const VibrationCase& setup : vibration_cases(study)) support_motion_of(setup, study);
  return [study, keep_history = study.value(&VibrationOutput::history)](Session& session) {
    const std::vector<VibrationResult> results = compute_vibration(study, session);
    session.results = nlohmann::json::array();
    for (const VibrationResult& result : results) session.results.push_back(to_json(result));
    write_amplitudes(session.directory, results);
    if (keep_history) write_history(session.directory, results);
    if (study.value(&VibrationOutput::sensitivities))
      write_sensitivities(session.directory, results);
    const std::string table =
        amplitude_table(results) + study.read<Pulse>().calibration_text() + warning_text(results);
    session.directory.log().info("greatest tip displacement over peak support displacement\n" +
                                 table);
    session.conclusion = table;
  };
}

StudyCost estimate_vibration(const Configuration& study) {
  const beam::Sampling sampling = study.read<BeamIntegration>().sampling();
  return {fmt::format("{} runs of {} samples with {} beam elements, by {}",
                      vibration_cases(study).size(), beam::sample_count(sampling),
                      study.value(&Beam::elements),
                      study.choice(study.key(&BeamIntegration::integrator)))};
}

std::string try_vibration(const Configuration& study, int threads) {
  using Clock = std::chrono::steady_clock;
  const auto cases = vibration_cases(study);
  const auto begin = Clock::now();
  fill_pipette(study, cases.front().fluid);  // loads deal.II, once
  const auto start = Clock::now();
  const FilledPipette pipette = fill_pipette(study, cases.front().fluid);
  const auto filled = Clock::now();
  compute_case(cases.front(), pipette, study.read<BeamIntegration>().sampling(), study);
  const std::chrono::duration<double> load = start - begin, fill = filled - start,
                                      one = Clock::now() - filled;
  const double fills = static_cast<double>(fills_of(study).size());
  const double all = static_cast<double>(cases.size()) / threads;
  return fmt::format("Here, from trying one on a thread of {}: about {}\n", threads,
                     duration_text(load.count() + fills * fill.count() + all * one.count()));
}

}  // namespace zona::studies
