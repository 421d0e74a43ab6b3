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

/// Tolerance for sums of time steps, relative to the length of the window.
constexpr double rounding = 1e-9;

HermitePoint interpolate(const beam::TipHistory& tip, double at) {
  const std::vector<double>& time = tip.time;
  const auto after = std::upper_bound(time.begin() + 1, time.end() - 1, at);
  const auto right = static_cast<std::size_t>(after - time.begin());
  const std::size_t left = right - 1;
  return hermite_cubic({time[left], tip.displacement[left], tip.velocity[left]},
                       {time[right], tip.displacement[right], tip.velocity[right]}, at);
}

/// The history with missing columns filled in.
beam::TipHistory completed(beam::TipHistory history) {
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

/// Displacement of a tip: sum of histories along unit axes.
template <class Part>
Eigen::Vector3d displacement_at(const std::vector<Part>& parts, double time) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Part& part : parts) sum += interpolate(part.history, time).value * part.axis;
  return sum;
}

/// First time at which the tip's distance from its place at `first` reaches a fraction of the
/// largest distance at any sample until `last`.
template <class Part>
double onset(const std::vector<Part>& parts, double first, double last, double fraction) {
  if (!(fraction > 0 && fraction < 1))
    throw std::invalid_argument(
        fmt::format("onset of motion: the fraction {} must lie between 0 and 1", fraction));
  const Eigen::Vector3d origin = displacement_at(parts, first);
  const auto departure = [&](double time) {
    return (displacement_at(parts, time) - origin).norm();
  };
  std::vector<double> times;
  for (const Part& part : parts)
    for (const double time : part.history.time)
      if (time >= first && time <= last) times.push_back(time);
  std::sort(times.begin(), times.end());
  double largest = 0;
  for (const double time : times) largest = std::max(largest, departure(time));
  if (largest == 0) throw std::invalid_argument("onset of motion: the tip never moves");
  std::size_t crossed = 0;
  while (departure(times[crossed]) < fraction * largest) ++crossed;
  double before = times[crossed - 1];
  double after = times[crossed];
  for (double middle = (before + after) / 2; before < middle && middle < after;
       middle = (before + after) / 2)
    (departure(middle) < fraction * largest ? before : after) = middle;
  return after;
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
  const std::vector<DirectedHistory> only{{completed(history), Eigen::Vector3d::UnitX()}};
  const std::vector<double>& time = only.front().history.time;
  return onset(only, time.front(), time.back(), fraction);
}

TipMotion::TipMotion(const beam::TipHistory& history, const TipMotionOptions& options)
    : TipMotion(std::vector<DirectedHistory>{{history, options.axis}}, options) {}

TipMotion::TipMotion(const beam::TipHistory& history, const TipMotionOptions& options,
                     const DirectedHistory& second)
    : TipMotion(std::vector<DirectedHistory>{{history, options.axis}, second}, options) {}

TipMotion::TipMotion(std::vector<DirectedHistory> histories, const TipMotionOptions& options)
    : scale_(options.scale), ramp_(options.ramp) {
  check_options(options);
  for (DirectedHistory& directed : histories)
    parts_.push_back({completed(std::move(directed.history)), unit_axis(directed.axis), 0});
  double first = parts_.front().history.time.front(), last = parts_.front().history.time.back();
  for (const Part& part : parts_) {
    first = std::max(first, part.history.time.front());
    last = std::min(last, part.history.time.back());
  }
  start_ = options.start ? *options.start : onset(parts_, first, last, options.start_fraction);
  length_ = options.length ? *options.length : last - start_;
  check_window(start_, length_, first, last);
  for (Part& part : parts_) part.offset = interpolate(part.history, start_).value;
}

mpm::RigidState TipMotion::operator()(double time) const {
  if (!(time >= -rounding * length_ && time <= (1 + rounding) * length_))
    throw std::out_of_range(fmt::format(
        "tip motion: evaluated at {} s, but the window is {} s long ({} s to {} s of the "
        "history); lengthen the window or end the run earlier",
        time, length_, start_, start_ + length_));
  const double inside = std::clamp(time, 0.0, length_);
  const Ramp ramp = smooth_ramp(inside, ramp_);
  const auto state_of = [&](const Part& part) -> mpm::RigidState {
    const double at = std::min(start_ + inside, part.history.time.back());
    const HermitePoint tip = interpolate(part.history, at);
    const double moved = scale_ * (tip.value - part.offset);
    return {ramp.value * moved * part.axis,
            (ramp.slope * moved + ramp.value * scale_ * tip.slope) * part.axis};
  };
  mpm::RigidState state = state_of(parts_.front());
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    const mpm::RigidState other = state_of(parts_[i]);
    state.displacement += other.displacement;
    state.velocity += other.velocity;
  }
  return state;
}

double TipMotion::initial_speed() const {
  const auto speed = [this](const Part& part) {
    return scale_ * interpolate(part.history, start_).slope;
  };
  if (parts_.size() == 1) return speed(parts_.front());
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  for (const Part& part : parts_) velocity += speed(part) * part.axis;
  return velocity.norm();
}

}  // namespace zona::coupling
