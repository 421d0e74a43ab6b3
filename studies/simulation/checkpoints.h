#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "mpm/files/checkpoint.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// When a run stores its state, and whether it starts from one.
struct CheckpointPlan {
  double interval = 300;   ///< wall time between two [s]; zero: none by time
  std::int64_t steps = 0;  ///< steps between two; zero: none by steps
  std::string study;       ///< what only checkpoints of this study share
  bool resume = false;     ///< start from the newest one, if there is one
};

/// As the [run] table says.
CheckpointPlan checkpoint_plan(const Configuration& study, bool resume);

/// The checkpoints of one run, the latest two: DIRECTORY/checkpoint-000000012000.h5, by step.
class Checkpoints {
 public:
  /// Looks for the newest whole checkpoint if the plan is to resume. Throws CheckpointError when
  /// there are some, but none is whole or one is of another study or version.
  Checkpoints(std::filesystem::path directory, CheckpointPlan plan);

  /// Whether the run starts from a checkpoint: `restore` it.
  bool is_resumed() const { return start_.has_value(); }
  void restore(const mpm::VisitState& visit) const { start_->restore(visit); }
  /// What the user should know of damaged ones, or of another processor; empty if there is nothing.
  const std::string& warning() const { return warning_; }

  bool is_due(std::int64_t step) const;
  /// Whether it stored one: not where the run has just started from it.
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

/// Removes the checkpoints of a run that is complete, also of the runs in its subdirectories.
void remove_checkpoints(const std::filesystem::path& directory);

}  // namespace zona::studies
