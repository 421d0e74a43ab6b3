#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/kinds/study_kinds.h"
#include "studies/run/run_directory.h"
#include "studies/run/summary.h"

namespace zona::studies {

/// What the program answers its caller; others script against these numbers.
enum ExitCode {
  exit_ok = 0,
  exit_bad_input = 2,
  exit_failed = 3,
  exit_not_verified = 4,
  exit_interrupted = 130
};

/// `zona run`.
struct RunOptions {
  std::filesystem::path file;  ///< or the directory of the run to go on with
  std::filesystem::path out;   ///< empty: runs/<name of the file>
  bool out_given = false;
  std::vector<std::string> overrides;  ///< key=TOML-value
  int threads = 0;                     ///< 0: what the study says, or all
  bool quiet = false;
  bool resume = false;  ///< go on in the directory of a run
};

/// Validates the study, then computes it in a new run directory, or goes on in an old one. Throws
/// InputError before anything is written; a failure later is reported, logged and gives
/// exit_failed.
int run_study(RunOptions options);

/// Runs one study of a kind; `run_study` after validation.
int run_configuration(const Configuration& study, const StudyKind& kind, const RunOptions& options);

/// How a study is computed.
struct ComputeOptions {
  int threads = 0;  ///< 0: what the study says, or all
  bool quiet = false;
  bool resume = false;  ///< go on from the checkpoints in the directory
  std::function<void(double fraction)> publish_fraction{};  ///< hears how far a stage is
};

/// Computes a valid study into a run directory. Whatever happens becomes the outcome, so that the
/// summary is written in any case. Throws InputError for what `prepare` finds.
RunOutcome compute_study(const Configuration& study, const StudyKind& kind, RunDirectory& directory,
                         const ComputeOptions& options);

/// Threads that a run takes: as wanted, else (0) as the study says, else all.
int threads_for(const Configuration& study, long wanted);

/// `zona check`: prints every parameter in SI, what the study will cost, and what that means on
/// this machine, from trying its first steps.
int check_study(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// `zona report`: writes report.html and the folder report into the directory of a run, and prints
/// where. Throws InputError for what is no run, RunError when Python fails.
int write_report(const std::filesystem::path& directory);

/// `zona status`: prints how far the run in a directory is, or how it ended. Throws InputError for
/// what is no run.
int show_status(const std::filesystem::path& directory);

/// `zona list`: study kinds and bundled study files.
int list_studies();

/// Calls `command` and turns what it throws into messages on the error stream and an exit code.
int with_messages(const std::function<int()>& command);

}  // namespace zona::studies
