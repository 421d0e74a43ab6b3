#include "coupling/tip_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "coupling/hermite.h"
#include "coupling/prescribed_motion.h"
#include "coupling/ramp.h"
#include "coupling/slopes.h"
#include "coupling/tip_trace.h"

namespace zona::coupling {

namespace {

using Samples = std::vector<double>;

/// Relative to the window's length: what sums of time steps may be off by.
constexpr double rounding = 1e-9;

Sample interpolate(const Samples& time, const Samples& value, const Samples& slope, double at) {
  const auto after = std::upper_bound(time.begin() + 1, time.end() - 1, at);
  const auto right = static_cast<std::size_t>(after - time.begin());
  const std::size_t left = right - 1;
  return hermite_cubic({time[left], value[left], slope[left]},
                       {time[right], value[right], slope[right]}, at);
}

/// The history with velocities, and nothing else that may be missing.
beam::TipHistory prepared(beam::TipHistory history) {
  complete_tip_history(history, "tip history");
  return history;
}

void check_options(const TipMotionOptions& options) {
  if (!std::isfinite(options.scale))
    throw std::invalid_argument(fmt::format("tip motion: scale {} is not finite", options.scale));
  if (!(options.ramp >= 0) || !std::isfinite(options.ramp))
    throw std::invalid_argument(
        fmt::format("tip motion: ramp {} s must not be negative", options.ramp));
  if (options.length && !(*options.length > 0))
    throw std::invalid_argument(
        fmt::format("tip motion: window length {} s must be positive", *options.length));
}

void check_window(double start, double length, double first, double last) {
  if (start >= first && length > 0 && start + length <= last + rounding * length) return;
  throw std::out_of_range(
      fmt::format("tip motion: the window from {} s, {} s long, ends at {} s; the history spans "
                  "only {} s to {} s",
                  start, length, start + length, first, last));
}

}  // namespace

double onset_of_motion(const beam::TipHistory& history, double fraction) {
  if (!(fraction > 0 && fraction < 1))
    throw std::invalid_argument(
        fmt::format("onset of motion: the fraction {} must lie between 0 and 1", fraction));
  const beam::TipHistory tip = prepared(history);
  const auto departure = [&](double displacement) {
    return std::abs(displacement - tip.displacement.front());
  };
  double largest = 0;
  for (const double displacement : tip.displacement)
    largest = std::max(largest, departure(displacement));
  if (largest == 0) throw std::invalid_argument("onset of motion: the tip never moves");
  std::size_t crossed = 0;
  while (departure(tip.displacement[crossed]) < fraction * largest) ++crossed;
  double before = tip.time[crossed - 1];
  double after = tip.time[crossed];
  for (double middle = (before + after) / 2; before < middle && middle < after;
       middle = (before + after) / 2) {
    const double there = interpolate(tip.time, tip.displacement, tip.velocity, middle).value;
    (departure(there) < fraction * largest ? before : after) = middle;
  }
  return after;
}

TipMotion::TipMotion(beam::TipHistory history, const TipMotionOptions& options)
    : scale_(options.scale), ramp_(options.ramp), axis_(unit_axis(options.axis)) {
  check_options(options);
  history = prepared(std::move(history));
  start_ = options.start ? *options.start : onset_of_motion(history, options.start_fraction);
  length_ = options.length ? *options.length : history.time.back() - start_;
  check_window(start_, length_, history.time.front(), history.time.back());
  time_ = std::move(history.time);
  displacement_ = std::move(history.displacement);
  velocity_ = std::move(history.velocity);
  offset_ = interpolate(time_, displacement_, velocity_, start_).value;
}

mpm::RigidState TipMotion::operator()(double time) const {
  if (!(time >= -rounding * length_ && time <= (1 + rounding) * length_))
    throw std::out_of_range(
        fmt::format("tip motion: asked at {} s, the window is {} s long ({} s to {} s of the "
                    "history); lengthen the window or end the run earlier",
                    time, length_, start_, start_ + length_));
  const double inside = std::clamp(time, 0.0, length_);
  const double at = std::min(start_ + inside, time_.back());
  const Sample tip = interpolate(time_, displacement_, velocity_, at);
  const double moved = scale_ * (tip.value - offset_);
  const Ramp ramp = smooth_ramp(inside, ramp_);
  return {ramp.value * moved * axis_,
          (ramp.slope * moved + ramp.value * scale_ * tip.slope) * axis_};
}

double TipMotion::initial_speed() const {
  return scale_ * interpolate(time_, displacement_, velocity_, start_).slope;
}

}  // namespace zona::coupling
