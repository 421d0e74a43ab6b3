#pragma once

#include <array>
#include <chrono>

namespace zona::mpm {

/// Stages of a step whose time is measured.
enum class Stage {
  loads,     ///< loads on points
  advance,   ///< absorbing faces; momentum of the nodes (3.33)
  pressure,  ///< implicit pressure of the fluids
  gather,    ///< velocities and positions of points, momentum mapped back (3.34)-(3.38)
  finish,    ///< velocities of the nodes (3.39)
  update,    ///< strains and stresses that are not fused with `scatter`
  surface,   ///< stresses and failures of membranes
  index,     ///< points that changed cells
  scatter,   ///< strains and stresses of the other points; sums at the nodes (3.30)-(3.32)
  reorder    ///< sort of the storage
};
/// Number of stages.
inline constexpr int stage_count = 10;
/// Names, in the order of Stage.
inline constexpr std::array<const char*, stage_count> stage_names{
    "loads",  "advance", "pressure", "gather",  "finish",
    "update", "surface", "index",    "scatter", "reorder"};

/// Seconds spent in each stage.
using StageSeconds = std::array<double, stage_count>;

/// Adds the time between two marks to the stage that the second one ends.
class StageClock {
 public:
  /// Starts now. Keeps a reference to `seconds`.
  explicit StageClock(StageSeconds& seconds) : seconds_(seconds), last_(Clock::now()) {}

  /// Ends `stage`.
  void mark(Stage stage) {
    const auto now = Clock::now();
    seconds_[static_cast<int>(stage)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  StageSeconds& seconds_;
  Clock::time_point last_;
};

}  // namespace zona::mpm
