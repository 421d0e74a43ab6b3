#pragma once

#include <filesystem>
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
  int threads = 0;  ///< 0: as each study says
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

/// Computes a run, or leaves it as it is when it is done. What an earlier, unfinished campaign left
/// in its directory is replaced. Throws Interrupted.
RunReport carry_out(const PlannedRun& run, const Campaign& campaign);

}  // namespace zona::studies::verification
