#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "mpm/files/checkpoint.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// How often a run stores its state, and whether it starts from a stored one.
struct CheckpointPlan {
  double interval = 300;   ///< wall time between two checkpoints [s]; zero: none by time
  std::int64_t steps = 0;  ///< steps between two checkpoints; zero: none by steps
  std::string study;       ///< fingerprint of the study, the same in all its checkpoints
  bool resume = false;     ///< start from the newest checkpoint, if there is one
};

/// As the [run] table says.
CheckpointPlan checkpoint_plan(const Configuration& study, bool resume);

/// The checkpoints of one run, the latest two: DIRECTORY/checkpoint-000000012000.h5, by step.
class Checkpoints {
 public:
  /// Finds the newest undamaged checkpoint if the plan is to resume. Throws CheckpointError when
  /// all checkpoints are damaged, or the newest undamaged one is of another study or version.
  Checkpoints(std::filesystem::path directory, CheckpointPlan plan);

  /// The run starts from a checkpoint; call `restore`.
  bool is_resumed() const { return start_.has_value(); }
  void restore(const mpm::VisitState& visit) const { start_->restore(visit); }
  /// Warning of damaged checkpoints or of another processor; empty if there is none.
  const std::string& warning() const { return warning_; }

  bool is_due(std::int64_t step) const;
  /// Stores a checkpoint and removes all but the last two. Returns false, and stores nothing, at
  /// the step that the run started from.
  bool store(std::int64_t step, const mpm::VisitState& visit);

 private:
  using Clock = std::chrono::steady_clock;

  void find_start();

  std::filesystem::path directory_;
  CheckpointPlan plan_;
  std::optional<mpm::Checkpoint> start_;
  std::string warning_;
  std::int64_t last_step_ = 0;
  Clock::time_point last_time_ = Clock::now();
};

/// Removes all checkpoints in a directory and its subdirectories, once a run is complete.
void remove_checkpoints(const std::filesystem::path& directory);

}  // namespace zona::studies
