#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "studies/kinds/piercing/case.h"
#include "studies/run/progress.h"
#include "studies/run/study_kind.h"
#include "studies/simulation/solver_march.h"

namespace spdlog {
class logger;
}

namespace zona::studies {

/// How a piercing runs; it may be one of several that run side by side.
struct PiercingWork {
  const Configuration& study;  ///< for [[probe]], [[profile]], [[section]]
  OutputPlan plan;
  CheckpointPlan checkpoints;
  std::filesystem::path directory;  ///< exists; for its files
  int threads;
  spdlog::logger& log;
  Progress& progress;  ///< in a stage that lasts until the end of the piercing
  int part = 0;        ///< of that stage
};

/// Runs one piercing and writes history.csv, fields.h5, fields.xdmf and, for a tip history,
/// tip.csv. `results` becomes its entry of summary.json; when interrupted, of what was computed,
/// and so too when a point goes wrong (mpm::PointError passes through).
void run_piercing(const PiercingCase& piercing, const PiercingWork& work, nlohmann::json& results);

/// Points and steps of a piercing, in a line.
StudyCost piercing_cost(const PiercingCase& piercing);

}  // namespace zona::studies
