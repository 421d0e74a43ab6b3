#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/run/study_kind.h"

namespace zona::studies {

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

}  // namespace zona::studies
