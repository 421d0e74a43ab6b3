#pragma once

#include <array>
#include <chrono>

namespace zona::mpm {

/// Parts of a step whose time is taken.
enum class Stage { loads, advance, gather, finish, update, surface, index, scatter, reorder };
inline constexpr int stage_count = 9;
inline constexpr std::array<const char*, stage_count> stage_names{
    "loads", "advance", "gather", "finish", "update", "surface", "index", "scatter", "reorder"};

/// Seconds spent in each stage.
using StageSeconds = std::array<double, stage_count>;

/// Adds the time between its marks to the stage that each mark ends.
class StageClock {
 public:
  explicit StageClock(StageSeconds& seconds) : seconds_(seconds), last_(Clock::now()) {}

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
