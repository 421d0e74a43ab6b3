#pragma once

#include <functional>
#include <string>

#include "studies/run/run_directory.h"
#include "studies/run/study_kind.h"
#include "studies/run/summary.h"

namespace zona::studies {

/// How a study is computed.
struct ComputeOptions {
  int threads = 0;  ///< 0: what the study says, or all
  bool quiet = false;
  bool resume = false;  ///< go on from the checkpoints in the directory
  std::function<void(double fraction)>
      publish_fraction{};  ///< receives the fraction of a stage that is done
};

/// Computes a valid study into a run directory. Turns every failure into an outcome, so that the
/// summary is always written. Throws InputError for what `prepare` finds.
RunOutcome compute_study(const Configuration& study, const StudyKind& kind, RunDirectory& directory,
                         const ComputeOptions& options);

/// How a run ended and when: "complete after 12 s".
std::string end_of_run(const RunOutcome& outcome);

/// Threads that a run takes: as wanted, else (0) as the study says, else all.
int threads_for(const Configuration& study, long wanted);

}  // namespace zona::studies
