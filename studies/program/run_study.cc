#include "studies/program/run_study.h"

#include <fmt/format.h>
#include <omp.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "studies/input/input_error.h"
#include "studies/kinds/study_kinds.h"
#include "studies/parameters/run_table.h"
#include "studies/program/compute_study.h"
#include "studies/program/exit_code.h"
#include "studies/program/status.h"
#include "studies/run/interrupt.h"
#include "studies/run/progress.h"
#include "studies/run/provenance.h"
#include "studies/run/resolved_study.h"
#include "studies/run/run_directory.h"
#include "studies/run/summary.h"
#include "studies/simulation/checkpoints.h"

namespace zona::studies {

namespace {

RunDirectory make_directory(const RunOptions& options) {
  return options.out_given ? RunDirectory::named(options.out)
                           : RunDirectory::for_study(options.file);
}

bool is_complete(const RunDirectory& directory) {
  std::ifstream stream(directory.file("summary.json"));
  const auto summary = nlohmann::json::parse(stream, nullptr, false);
  return summary.is_object() && summary.value("status", "") == "complete";
}

/// Throws InputError when a run was started with another study.
void check_same_study(const Configuration& study, const RunDirectory& directory) {
  const Configuration before = load_configuration(directory.file("study.toml"), {});
  const std::string difference = first_difference(before, study);
  if (difference.empty()) return;
  throw InputError(
      directory.path().string(),
      fmt::format("was computed from another study: {}; go on with the old one, \"zona "
                  "run {} --resume\", or start anew in another directory",
                  difference, directory.path().string()));
}

int report(const RunOutcome& outcome, const RunDirectory& directory, bool quiet) {
  std::cout << outcome.conclusion << std::flush;
  if (outcome.status == "failed") {
    std::cerr << "zona: " << outcome.message << "\nwhat was computed until then is in "
              << directory.path().string() << '\n';
    return exit_failed;
  }
  if (!quiet) std::cerr << end_of_run(outcome) << "; see " << directory.path().string() << '\n';
  if (!quiet && outcome.status == "interrupted") {
    std::cerr << "go on with \"zona run " << directory.path().string() << " --resume\"\n";
  }
  return outcome.status == "interrupted" ? exit_interrupted : exit_ok;
}

}  // namespace

int run_configuration(const Configuration& study, const StudyKind& kind,
                      const RunOptions& options) {
  kind.prepare(study);  // refuses what is wrong before a directory is made
  RunDirectory directory =
      options.resume ? RunDirectory::of_run(options.out) : make_directory(options);
  if (options.resume) {
    check_same_study(study, directory);
    if (is_complete(directory)) {
      if (!options.quiet) std::cerr << directory.path().string() << " is complete\n";
      return exit_ok;
    }
  }
  const RunOutcome outcome =
      compute_study(study, kind, directory, {options.threads, options.quiet, options.resume});
  return report(outcome, directory, options.quiet);
}

int run_study(RunOptions options) {
  if (options.resume && std::filesystem::is_directory(options.file)) {
    options.out = options.file;
    options.file = options.out / "study.toml";
  } else if (options.resume && !options.out_given) {
    options.out = RunDirectory::last_for_study(options.file);
  }
  const Configuration study = load_configuration(options.file, options.overrides);
  return run_configuration(study, find_study_kind(study.kind()), options);
}

}  // namespace zona::studies
