#pragma once

#include <Eigen/Core>

namespace zona::beam {

/// Half of the damping coefficient of a mode under Rayleigh damping, (alpha + beta omega^2) / 2
/// [1/s].
Eigen::ArrayXd decay_rate(const Eigen::ArrayXd& angular_frequency, double alpha, double beta);

/// Exact solution operator over a time span of the oscillators x'' + 2 sigma x' + omega^2 x = 0:
/// x1 = xx x0 + xv v0 and v1 = vx x0 + vv v0, for any damping.
struct OscillatorTransition {
  Eigen::ArrayXd xx, xv, vx, vv;
};

OscillatorTransition transition(const Eigen::ArrayXd& angular_frequency,
                                const Eigen::ArrayXd& decay_rate, double time);

/// Displacement of one such oscillator `time` after it was at rest and its velocity jumped to 1,
/// and the velocity then. Zero before the jump.
struct ImpulseResponse {
  double displacement = 0;
  double velocity = 0;
};

ImpulseResponse impulse_response(double angular_frequency, double decay_rate, double time);

}  // namespace zona::beam
