#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/verification/evaluation/verification_case.h"

namespace zona::studies::verification {

/// A validated run of a case.
struct PlannedRun {
  const Case* owner;
  Run run;
  Configuration study;
  std::filesystem::path directory;
  double point_steps;  ///< estimated; 0 where it means nothing
  bool is_done;        ///< by an earlier campaign
};

/// Settings for computing the runs of cases.
struct Campaign {
  std::filesystem::path directory;  ///< runs lie in <directory>/<case>/<label>
  Extent extent;
  int threads = 0;  ///< of all runs together; 0: all that the machine has
  bool quiet = false;
};

/// Validates every run of the cases before one starts. A run counts as done when its directory
/// holds the complete results of the same resolved study by the same version of the program.
/// Throws InputError.
std::vector<PlannedRun> plan(const std::vector<const Case*>& cases, const Campaign& campaign);

/// The user stopped the campaign.
struct Interrupted {};

/// Outcome of a run; `message` is the reason of a failure.
struct RunReport {
  std::string status;  ///< as in summary.json
  std::string message;
};

/// Called at the end of a run, from several threads at once. Returns a line for the user, or "".
using RunEnded = std::function<std::string(std::size_t run, const RunReport& report)>;

/// Computes the runs that are not done in parallel, the longest first, and shows the progress. A
/// run gets threads in proportion to its work, one if there are many runs. Replaces what an
/// unfinished campaign left in a directory. Throws Interrupted.
void carry_out(const std::vector<PlannedRun>& runs, const Campaign& campaign,
               const RunEnded& run_ended);

}  // namespace zona::studies::verification
