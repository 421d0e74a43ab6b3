#include "beam/motion/support_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam/algebra/require.h"

namespace zona::beam {
namespace {

void check_one(const SampledMotion& motion) {
  const auto& [time, displacement] = motion;
  require(time.size() == displacement.size() && time.size() >= 2,
          fmt::format("support motion: {} times and {} displacements, but both must have the same "
                      "number, at least 2; give one displacement per time",
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
                        "the previous sample, {} s; sort the samples and drop repeated times",
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

void check_pulse(const char* name, double peak, double duration) {
  require(is_positive(duration),
          fmt::format("{} pulse: duration is {} s, but it must be greater than 0", name, duration));
  require(std::isfinite(peak),
          fmt::format("{} pulse: peak is {} m, but it must be finite", name, peak));
}

}  // namespace

SupportMotion triangular_pulse(double peak, double duration) {
  check_pulse("triangular", peak, duration);
  return SampledMotion{{0, duration / 2, duration}, {0, peak, 0}};
}

SupportMotion trapezoidal_pulse(double peak, double duration, double rise) {
  check_pulse("trapezoidal", peak, duration);
  require(is_positive(rise) && 2 * rise <= duration * (1 + 1e-12),
          fmt::format("trapezoidal pulse: a rise of {} s, but it must be above 0 and at most half "
                      "the duration, {} s",
                      rise, duration / 2));
  if (2 * rise >= duration * (1 - 1e-12)) return triangular_pulse(peak, duration);
  return SampledMotion{{0, rise, duration - rise, duration}, {0, peak, peak, 0}};
}

SupportMotion half_sine_pulse(double peak, double duration) {
  check_pulse("half-sine", peak, duration);
  constexpr int pieces = 128;
  SampledMotion motion;
  for (int i = 0; i <= pieces; ++i) {
    motion.time.push_back(duration * i / pieces);
    motion.displacement.push_back(i % pieces == 0 ? 0 : peak * std::sin(M_PI * i / pieces));
  }
  return motion;
}

SupportMotion pulse_train(const SupportMotion& pulse, int count, double period) {
  check(pulse);
  const auto* one = std::get_if<SampledMotion>(&pulse);
  require(one != nullptr && one->displacement.back() == 0,
          "pulse train: only pulses that end where they begin can be repeated");
  require(count >= 1, fmt::format("pulse train: {} pulses, but at least 1 is needed", count));
  require(
      count == 1 || period >= one->time.back() - one->time.front(),
      fmt::format("pulse train: a pulse of {} s every {} s; lower the rate or shorten the pulse",
                  one->time.back() - one->time.front(), period));
  SampledMotion train;
  for (int n = 0; n < count; ++n)
    for (std::size_t i = 0; i < one->time.size(); ++i) {
      const double time = n * period + one->time[i];
      // A pulse that begins when the previous one ends shares a sample with it.
      if (!train.time.empty() && time <= train.time.back() * (1 + 1e-12)) continue;
      train.time.push_back(time);
      train.displacement.push_back(one->displacement[i]);
    }
  return train;
}

SupportMotion scaled(const SupportMotion& motion, double factor) {
  require(std::isfinite(factor),
          fmt::format("support motion: the factor {} is not finite; give a number", factor));
  SupportMotion result = motion;
  if (auto* pieces = std::get_if<SampledMotion>(&result))
    for (double& displacement : pieces->displacement) displacement *= factor;
  if (auto* sine = std::get_if<SineMotion>(&result)) sine->amplitude *= factor;
  return result;
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
