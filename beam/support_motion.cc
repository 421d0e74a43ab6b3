#include "beam/support_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam/require.h"

namespace zona::beam {
namespace {

void check_one(const SampledMotion& motion) {
  const auto& [time, displacement] = motion;
  require(
      time.size() == displacement.size() && time.size() >= 2,
      fmt::format("support motion: {} times and {} displacements, but both must be equally many "
                  "and at least 2; give one displacement per time",
                  time.size(), displacement.size()));
  require(
      time.front() >= 0 && displacement.front() == 0,
      fmt::format("support motion: the first sample is {} m at {} s, but the support rests at 0 "
                  "before t = 0; begin with displacement 0 at a time >= 0",
                  displacement.front(), time.front()));
  for (std::size_t i = 0; i < time.size(); ++i) {
    require(std::isfinite(time[i]) && std::isfinite(displacement[i]),
            fmt::format("support motion: sample {} ({} m at {} s) is not finite; remove it", i,
                        displacement[i], time[i]));
    require(i == 0 || time[i] > time[i - 1],
            fmt::format("support motion: the time of sample {}, {} s, is not greater than that of "
                        "the sample before, {} s; sort the samples and drop repeated times",
                        i, time[i], i == 0 ? 0. : time[i - 1]));
  }
}

void check_one(const SineMotion& motion) {
  require(
      std::isfinite(motion.amplitude) && is_positive(motion.angular_frequency),
      fmt::format("support motion: a sine of amplitude {} m at {} rad/s, but the amplitude must "
                  "be finite and the angular frequency greater than 0",
                  motion.amplitude, motion.angular_frequency));
}

/// Index of the first sample later than the time.
std::size_t next_sample(const SampledMotion& motion, double time) {
  return std::upper_bound(motion.time.begin(), motion.time.end(), time) - motion.time.begin();
}

/// Slope of the piece that ends at the sample, zero outside the samples.
double slope_before(const SampledMotion& motion, std::size_t sample) {
  if (sample == 0 || sample == motion.time.size()) return 0;
  return (motion.displacement[sample] - motion.displacement[sample - 1]) /
         (motion.time[sample] - motion.time[sample - 1]);
}

double displacement_of(const SampledMotion& motion, double time) {
  const std::size_t next = next_sample(motion, time);
  if (next == 0) return motion.displacement.front();
  if (next == motion.time.size()) return motion.displacement.back();
  return motion.displacement[next - 1] +
         slope_before(motion, next) * (time - motion.time[next - 1]);
}

double displacement_of(const SineMotion& motion, double time) {
  return time < 0 ? 0 : motion.amplitude * std::sin(motion.angular_frequency * time);
}

double velocity_of(const SampledMotion& motion, double time) {
  return slope_before(motion, next_sample(motion, time));
}

double velocity_of(const SineMotion& motion, double time) {
  return time < 0 ? 0
                  : motion.amplitude * motion.angular_frequency *
                        std::cos(motion.angular_frequency * time);
}

double smooth_acceleration_of(const SampledMotion&, double) {
  return 0;
}

double smooth_acceleration_of(const SineMotion& motion, double time) {
  const double omega = motion.angular_frequency;
  return time < 0 ? 0 : -motion.amplitude * omega * omega * std::sin(omega * time);
}

std::vector<Kink> kinks_of(const SampledMotion& motion) {
  std::vector<Kink> kinks;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    const double jump = slope_before(motion, i + 1) - slope_before(motion, i);
    if (jump != 0) kinks.push_back({motion.time[i], jump});
  }
  return kinks;
}

std::vector<Kink> kinks_of(const SineMotion& motion) {
  return {{0, motion.amplitude * motion.angular_frequency}};
}

double peak_displacement_of(const SampledMotion& motion) {
  double peak = 0;
  for (const double value : motion.displacement) peak = std::max(peak, std::abs(value));
  return peak;
}

double peak_displacement_of(const SineMotion& motion) {
  return std::abs(motion.amplitude);
}

double peak_velocity_of(const SampledMotion& motion) {
  double peak = 0;
  for (std::size_t i = 1; i < motion.time.size(); ++i)
    peak = std::max(peak, std::abs(slope_before(motion, i)));
  return peak;
}

double peak_velocity_of(const SineMotion& motion) {
  return std::abs(motion.amplitude) * motion.angular_frequency;
}

}  // namespace

SupportMotion triangular_pulse(double peak, double duration) {
  require(
      is_positive(duration),
      fmt::format("triangular pulse: duration is {} s, but it must be greater than 0", duration));
  require(std::isfinite(peak),
          fmt::format("triangular pulse: peak is {} m, but it must be finite", peak));
  return SampledMotion{{0, duration / 2, duration}, {0, peak, 0}};
}

void check(const SupportMotion& motion) {
  std::visit([](const auto& m) { check_one(m); }, motion);
}

double displacement(const SupportMotion& motion, double time) {
  return std::visit([time](const auto& m) { return displacement_of(m, time); }, motion);
}

double velocity(const SupportMotion& motion, double time) {
  return std::visit([time](const auto& m) { return velocity_of(m, time); }, motion);
}

double smooth_acceleration(const SupportMotion& motion, double time) {
  return std::visit([time](const auto& m) { return smooth_acceleration_of(m, time); }, motion);
}

std::vector<Kink> kinks(const SupportMotion& motion) {
  return std::visit([](const auto& m) { return kinks_of(m); }, motion);
}

double peak_displacement(const SupportMotion& motion) {
  return std::visit([](const auto& m) { return peak_displacement_of(m); }, motion);
}

double peak_velocity(const SupportMotion& motion) {
  return std::visit([](const auto& m) { return peak_velocity_of(m); }, motion);
}

}  // namespace zona::beam
