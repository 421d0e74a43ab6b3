#include "beam/system/oscillator.h"

#include <cmath>

namespace zona::beam {

Eigen::ArrayXd decay_rate(const Eigen::ArrayXd& angular_frequency, double alpha, double beta) {
  return 0.5 * (alpha + beta * angular_frequency.square());
}

ImpulseResponse impulse_response(double omega, double sigma, double time) {
  if (time < 0) return {};
  const double discriminant = omega * omega - sigma * sigma;
  if (discriminant > 0) {
    const double damped = std::sqrt(discriminant);
    const double decay = sigma == 0 ? 1 : std::exp(-sigma * time);
    const double sine = decay * std::sin(damped * time) / damped;
    return {sine, decay * std::cos(damped * time) - sigma * sine};
  }
  // Overdamped: two real rates. omega^2 / fast gives the slow one without cancellation.
  const double spread = std::sqrt(-discriminant);
  const double fast = sigma + spread;
  const double slow = omega * omega / fast;
  if (spread * time < 1e-8) {
    const double decay = std::exp(-sigma * time);
    return {time * decay, (1 - sigma * time) * decay};
  }
  const double slow_decay = std::exp(-slow * time);
  const double fast_decay = std::exp(-fast * time);
  return {(slow_decay - fast_decay) / (2 * spread),
          (fast * fast_decay - slow * slow_decay) / (2 * spread)};
}

OscillatorTransition transition(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& sigma,
                                double time) {
  const Eigen::Index n = omega.size();
  OscillatorTransition result{Eigen::ArrayXd(n), Eigen::ArrayXd(n), Eigen::ArrayXd(n),
                              Eigen::ArrayXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto [displacement, velocity] = impulse_response(omega(i), sigma(i), time);
    result.xv(i) = displacement;
    result.vv(i) = velocity;
    result.xx(i) = velocity + 2 * sigma(i) * displacement;
    result.vx(i) = -omega(i) * omega(i) * displacement;
  }
  return result;
}

}  // namespace zona::beam
