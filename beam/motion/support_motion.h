#pragma once

#include <variant>
#include <vector>

namespace zona::beam {

/// Support displacement g(t) that is straight between samples, constant at the first value before
/// the first sample and at the last value after the last one. Its acceleration is zero except at
/// the kinks, where the slope jumps.
struct SampledMotion {
  std::vector<double> time;          ///< strictly increasing [s]
  std::vector<double> displacement;  ///< [m]
};

/// g(t) = amplitude sin(angular_frequency t) for t >= 0, at rest before. The support of
/// Figure 5.26: at t = 0 its velocity jumps to amplitude * angular_frequency.
struct SineMotion {
  double amplitude = 0;          ///< [m]
  double angular_frequency = 0;  ///< [rad/s]
};

/// Displacement of the support of a beam, across it or along it, which is at rest at zero before t
/// = 0.
using SupportMotion = std::variant<SampledMotion, SineMotion>;

/// An instant at which the support's velocity jumps, i.e. its acceleration is an impulse.
struct Kink {
  double time = 0;           ///< [s]
  double velocity_jump = 0;  ///< [m/s]
};

/// The piezo pulse of Figure 5.27: from 0 linearly to the peak [m] at half the duration [s] and
/// back. Throws std::invalid_argument if the duration is not positive or the peak not finite.
SupportMotion triangular_pulse(double peak, double duration);

/// Up to the peak [m] in `rise` [s], held, and down in as much time, all in the duration [s].
/// Throws std::invalid_argument unless 0 < 2 rise <= duration and the peak is finite.
SupportMotion trapezoidal_pulse(double peak, double duration, double rise);

/// Half a period of a sine, which starts and ends with a jump of velocity, as 128 straight pieces:
/// 7.5e-5 of the peak [m] off at most. Throws as triangular_pulse does.
SupportMotion half_sine_pulse(double peak, double duration);

/// `count` times a motion of straight pieces, begun every `period` [s]. Throws
/// std::invalid_argument for a sine, a count below 1, a motion that does not end where it began, or
/// one that lasts longer than the period.
SupportMotion pulse_train(const SupportMotion& pulse, int count, double period);

/// The motion with its displacements times a finite factor.
SupportMotion scaled(const SupportMotion& motion, double factor);

/// Throws std::invalid_argument, naming the sample, unless the samples are finite, as many as their
/// times, at strictly increasing times >= 0, and begin at 0 displacement; or the sine is finite.
void check(const SupportMotion& motion);

/// g(t) [m].
double displacement(const SupportMotion& motion, double time);

/// g'(t) [m/s]; at a kink the value just after it.
double velocity(const SupportMotion& motion, double time);

/// g''(t) [m/s^2] without the impulses at the kinks.
double smooth_acceleration(const SupportMotion& motion, double time);

/// The kinks with a jump of velocity, in the order of time.
std::vector<Kink> kinks(const SupportMotion& motion);

/// Greatest |g(t)| over all times [m].
double peak_displacement(const SupportMotion& motion);

/// Greatest |g'(t)| over all times [m/s].
double peak_velocity(const SupportMotion& motion);

}  // namespace zona::beam
