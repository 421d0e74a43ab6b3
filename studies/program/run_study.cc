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
#include "studies/program/commands.h"
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

/// Whatever happens becomes a status, but for checkpoints that cannot be gone on from: then nothing
/// has been computed, and the summary that is there stays. Throws InputError.
void carry_out(const Job& job, Session& session, RunOutcome& outcome) {
  const Interrupt interrupt;
  const auto started = std::chrono::steady_clock::now();
  try {
    job(session);
    outcome.status = Interrupt::requested() ? "interrupted" : "complete";
  } catch (const mpm::CheckpointError& error) {
    throw InputError("--resume", error.what());
  } catch (const std::exception& error) {
    outcome.status = "failed";
    outcome.message = error.what();
  }
  outcome.wall_time =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  outcome.conclusion = session.conclusion;
}

std::string last_words(const RunOutcome& outcome) {
  return fmt::format("{} after {}", outcome.status, duration_text(outcome.wall_time));
}

int report(const RunOutcome& outcome, const RunDirectory& directory, bool quiet) {
  std::cout << outcome.conclusion << std::flush;
  if (outcome.status == "failed") {
    std::cerr << "zona: " << outcome.message << "\nwhat was computed until then is in "
              << directory.path().string() << '\n';
    return exit_failed;
  }
  if (!quiet) std::cerr << last_words(outcome) << "; see " << directory.path().string() << '\n';
  if (!quiet && outcome.status == "interrupted") {
    std::cerr << "go on with \"zona run " << directory.path().string() << " --resume\"\n";
  }
  return outcome.status == "interrupted" ? exit_interrupted : exit_ok;
}

}  // namespace

RunOutcome compute_study(const Configuration& study, const StudyKind& kind, RunDirectory& directory,
                         const ComputeOptions& options) {
  RunOutcome outcome;
  outcome.threads = threads_for(study, options.threads);
  outcome.started = local_time();
  omp_set_num_threads(outcome.threads);
  const Job job = kind.prepare(study);
  if (!options.resume) directory.write("study.toml", resolved_study(study));
  if (study.schema().binds<Run>()) {
    directory.log().set_level(study.value(&Run::log_level));
  }
  directory.log().info("{}, {} study of {}, {} threads", provenance(), study.kind(),
                       study.file().string(), outcome.threads);
  nlohmann::json results = nlohmann::json::object();
  {
    Progress progress(Progress::suitable_mode(options.quiet), std::cerr);
    progress.publish_to([&](const std::string& line) { leave_status(directory, line); });
    progress.publish_fraction_to(options.publish_fraction);
    Session session{directory, progress, results, outcome.threads, options.resume};
    carry_out(job, session, outcome);
  }
  directory.write("summary.json", summary_text(study, outcome, results));
  remove_status(directory);
  if (outcome.status == "complete") remove_checkpoints(directory.path());
  directory.log().log(
      outcome.status == "failed" ? spdlog::level::err : spdlog::level::info,
      last_words(outcome) + (outcome.message.empty() ? "" : ": " + outcome.message));
  return outcome;
}

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
