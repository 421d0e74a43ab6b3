#pragma once

#include <variant>
#include <vector>

namespace zona::beam {

/// Support displacement g(t), linear between samples and constant before the first and after the
/// last one. Its acceleration is zero except at the kinks, where the velocity jumps.
struct SampledMotion {
  std::vector<double> time;          ///< strictly increasing [s]
  std::vector<double> displacement;  ///< [m]
};

/// g(t) = amplitude sin(angular_frequency t) for t >= 0, at rest before (Figure 5.26). At t = 0 the
/// velocity jumps to amplitude * angular_frequency.
struct SineMotion {
  double amplitude = 0;          ///< [m]
  double angular_frequency = 0;  ///< [rad/s]
};

/// Displacement of a beam's support, across or along the beam; zero before t = 0.
using SupportMotion = std::variant<SampledMotion, SineMotion>;

/// An instant at which the support's velocity jumps, i.e. its acceleration has an impulse.
struct Kink {
  double time = 0;           ///< [s]
  double velocity_jump = 0;  ///< [m/s]
};

/// The piezo pulse of Figure 5.27: rises linearly to the peak [m] at half the duration [s] and
/// falls back to 0. Throws std::invalid_argument if the duration is not positive or the peak not
/// finite.
SupportMotion triangular_pulse(double peak, double duration);

/// Rises to the peak [m] in `rise` [s], stays there, and falls as fast, all within the duration
/// [s]. Throws std::invalid_argument unless 0 < 2 rise <= duration and the peak is finite.
SupportMotion trapezoidal_pulse(double peak, double duration, double rise);

/// Half a period of a sine, which starts and ends with a jump of velocity, as 128 straight pieces
/// with an error of at most 7.5e-5 of the peak [m]. Throws as triangular_pulse does.
SupportMotion half_sine_pulse(double peak, double duration);

/// Repeats a motion of straight pieces `count` times, one every `period` [s]. Throws
/// std::invalid_argument for a sine, a count below 1, a motion that does not end where it begins,
/// and one that lasts longer than the period.
SupportMotion pulse_train(const SupportMotion& pulse, int count, double period);

/// The motion with its displacements multiplied by a factor. Throws std::invalid_argument unless
/// the factor is finite.
SupportMotion scaled(const SupportMotion& motion, double factor);

/// Throws std::invalid_argument unless a sampled motion has finite samples, one per time, at
/// strictly increasing times >= 0, and starts at 0 displacement, or a sine has a finite amplitude
/// and a positive frequency.
void check(const SupportMotion& motion);

/// g(t) [m].
double displacement(const SupportMotion& motion, double time);

/// g'(t) [m/s]; at a kink the velocity just after it.
double velocity(const SupportMotion& motion, double time);

/// g''(t) [m/s^2] without the impulses at the kinks.
double smooth_acceleration(const SupportMotion& motion, double time);

/// Kinks in the order of time.
std::vector<Kink> kinks(const SupportMotion& motion);

/// Greatest |g(t)| over all times [m].
double peak_displacement(const SupportMotion& motion);

/// Greatest |g'(t)| over all times [m/s].
double peak_velocity(const SupportMotion& motion);

}  // namespace zona::beam
