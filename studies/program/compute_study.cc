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

}  // namespace

std::string end_of_run(const RunOutcome& outcome) {
  return fmt::format("{} after {}", outcome.status, duration_text(outcome.wall_time));
}

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
  directory.log().info(fmt::format("{}, {} study of {}, {} threads", provenance(), study.kind(),
                                   study.file().string(), outcome.threads));
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
      end_of_run(outcome) + (outcome.message.empty() ? "" : ": " + outcome.message));
  return outcome;
}

int threads_for(const Configuration& study, long wanted) {
  if (wanted == 0 && study.schema().binds<Run>()) wanted = study.value(&Run::threads);
  return wanted > 0 ? static_cast<int>(wanted) : omp_get_num_procs();
}

}  // namespace zona::studies
