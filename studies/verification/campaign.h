#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/verification/evaluation/verification_case.h"

namespace zona::studies::verification {

/// A run of a case that was validated, and whether an earlier campaign has computed it already.
struct PlannedRun {
  const Case* owner;
  Run run;
  Configuration study;
  std::filesystem::path directory;
  double point_steps;  ///< of the estimate; 0 where it means nothing
  bool is_done;
};

/// Where and how the runs of a set of cases are computed.
struct Campaign {
  std::filesystem::path directory;  ///< runs lie in <directory>/<case>/<label>
  Extent extent;
  int threads = 0;  ///< of all runs together; 0: all that the machine has
  bool quiet = false;
};

/// Validates every run of the cases before one starts. A run counts as done when its directory
/// holds the complete results of the very same resolved study by the same version of the program.
/// Throws InputError.
std::vector<PlannedRun> plan(const std::vector<const Case*>& cases, const Campaign& campaign);

/// The user stopped the campaign.
struct Interrupted {};

/// How a run of the campaign ended; `message` tells why it failed.
struct RunReport {
  std::string status;  ///< as in summary.json
  std::string message;
};

/// Hears that a run, given by its place among all, has ended. Called from several threads at once.
/// Returns a line for the user, or "".
using RunEnded = std::function<std::string(std::size_t run, const RunReport& report)>;

/// Computes the runs that are not done, side by side and the longest first, and tells the user how
/// far they are. A run gets as many threads as its share of the work; one when there are many. What
/// an earlier, unfinished campaign left in a directory is replaced. Throws Interrupted.
void carry_out(const std::vector<PlannedRun>& runs, const Campaign& campaign,
               const RunEnded& run_ended);

}  // namespace zona::studies::verification
