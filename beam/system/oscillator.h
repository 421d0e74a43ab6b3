#pragma once

#include <Eigen/Core>

namespace zona::beam {

/// Decay rate of a mode under Rayleigh damping, (alpha + beta omega^2) / 2 [1/s].
Eigen::ArrayXd decay_rate(const Eigen::ArrayXd& angular_frequency, double alpha, double beta);

/// Exact solution operator over a time span of the oscillators x'' + 2 sigma x' + omega^2 x = 0:
/// x1 = xx x0 + xv v0 and v1 = vx x0 + vv v0, for any damping.
struct OscillatorTransition {
  Eigen::ArrayXd xx;  ///< displacement by displacement [-]
  Eigen::ArrayXd xv;  ///< displacement by velocity [s]
  Eigen::ArrayXd vx;  ///< velocity by displacement [1/s]
  Eigen::ArrayXd vv;  ///< velocity by velocity [-]
};

/// The operator over `time` [s] for frequencies omega [rad/s] and decay rates sigma [1/s].
OscillatorTransition transition(const Eigen::ArrayXd& angular_frequency,
                                const Eigen::ArrayXd& decay_rate, double time);

/// Response of one such oscillator at rest to a unit jump of its velocity; zero before the jump.
struct ImpulseResponse {
  double displacement = 0;  ///< per velocity of the jump [s]
  double velocity = 0;      ///< per velocity of the jump [-]
};

/// The response at `time` [s] after the jump, for omega [rad/s] and sigma [1/s].
ImpulseResponse impulse_response(double angular_frequency, double decay_rate, double time);

}  // namespace zona::beam
