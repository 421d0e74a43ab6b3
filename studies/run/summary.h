#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "studies/input/configuration.h"

namespace zona::studies {

/// Outcome of a run, beside its results.
struct RunOutcome {
  std::string status;    ///< "complete", "interrupted" or "failed"
  std::string message;   ///< of a failure
  std::string started;   ///< local date and time
  double wall_time = 0;  ///< [s]
  int threads = 1;
  std::string conclusion;  ///< text of the study for the user
};

/// Content of summary.json: study, outcome, versions and the results of the study, in SI units.
/// Numbers that are not finite become null.
std::string summary_text(const Configuration& study, const RunOutcome& outcome,
                         const nlohmann::json& results);

}  // namespace zona::studies
