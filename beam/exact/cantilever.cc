#include "beam/exact/cantilever.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "beam/algebra/require.h"
#include "beam/system/oscillator.h"
#include "beam/time/modal_stepper.h"

namespace zona::beam {
namespace {

constexpr int max_modes = 100'000;

/// n-th root of cos z + 1 / cosh z = 0, by Newton's method from the nearest root of cos z.
double clamped_free_root(int mode) {
  double z = (mode - 0.5) * M_PI;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double sech = 2 * std::exp(-z) / (1 + std::exp(-2 * z));
    const double step = (std::cos(z) + sech) / (-std::sin(z) - sech * std::tanh(z));
    z -= step;
    if (std::abs(step) < 1e-15 * z) break;
  }
  return z;
}

/// sigma = (cosh z + cos z) / (sinh z + sin z), divided through by e^z / 2.
double sigma(double z) {
  const double decay = std::exp(-z);
  return (1 + decay * decay + 2 * decay * std::cos(z)) /
         (1 - decay * decay + 2 * decay * std::sin(z));
}

/// (1 - sigma) e^z / 2, with its two exponentially large terms cancelled analytically.
double growing_amplitude(double z) {
  const double decay = std::exp(-z);
  return (std::sin(z) - std::cos(z) - decay) / (1 - decay * decay + 2 * decay * std::sin(z));
}

void check_beam(const UniformBeam& beam, int modes) {
  require(
      is_positive(beam.length) && is_positive(beam.flexural_rigidity) &&
          is_positive(beam.mass_per_length),
      fmt::format("exact cantilever: length {} m, rigidity {} N m^2 and mass {} kg/m must all be "
                  "greater than 0",
                  beam.length, beam.flexural_rigidity, beam.mass_per_length));
  require(modes >= 1 && modes <= max_modes,
          fmt::format("exact cantilever: {} modes, but the number must lie between 1 and {}; 80 "
                      "suffice for a 60 us pulse",
                      modes, max_modes));
}

}  // namespace

ExactCantilever::ExactCantilever(const UniformBeam& beam, int modes) : beam_(beam) {
  check_beam(beam, modes);
  for (int mode = 1; mode <= modes; ++mode) root_.push_back(clamped_free_root(mode));
}

double ExactCantilever::angular_frequency(int mode) const {
  const double wave_number = root(mode) / beam_.length;
  return wave_number * wave_number * beam_.dispersion();
}

double ExactCantilever::shape(int mode, double x) const {
  const double z = root(mode);
  const double s = z * x / beam_.length;
  const double growing = growing_amplitude(z) * std::exp(s - z);
  const double decaying = (1 + sigma(z)) / 2 * std::exp(-s);
  return growing + decaying - std::cos(s) + sigma(z) * std::sin(s);
}

double ExactCantilever::tip_share(int mode) const {
  const double sign = mode % 2 == 1 ? 1 : -1;
  return 4 * sign * sigma(root(mode)) / root(mode);
}

RelativeMotion ExactCantilever::tip_relative(const std::vector<Kink>& kinks, double time,
                                             const RayleighDamping& damping) const {
  RelativeMotion relative;
  for (int mode = 1; mode <= modes(); ++mode) {
    const double omega = angular_frequency(mode);
    const double decay = (damping.alpha + damping.beta * omega * omega) / 2;
    ImpulseResponse response;
    for (const Kink& kink : kinks) {
      const auto [displacement, velocity] = impulse_response(omega, decay, time - kink.time);
      response.displacement += kink.velocity_jump * displacement;
      response.velocity += kink.velocity_jump * velocity;
    }
    const double share = tip_share(mode);
    relative.displacement -= share * response.displacement;
    relative.velocity -= share * response.velocity;
    relative.acceleration +=
        share * (omega * omega * response.displacement + 2 * decay * response.velocity);
  }
  return relative;
}

TipHistory ExactCantilever::tip_history(const SupportMotion& motion, const Sampling& sampling,
                                        const RayleighDamping& damping) const {
  check(motion);
  ModalOscillators oscillators;
  oscillators.angular_frequency.resize(modes());
  oscillators.participation.resize(modes());
  for (int mode = 1; mode <= modes(); ++mode) {
    oscillators.angular_frequency(mode - 1) = angular_frequency(mode);
    oscillators.participation(mode - 1) = tip_share(mode);
  }
  oscillators.observed = Eigen::ArrayXd::Ones(modes());
  oscillators.decay_rate = decay_rate(oscillators.angular_frequency, damping.alpha, damping.beta);
  ModalStepper stepper(std::move(oscillators), motion, sampling.step);
  return march(1, motion, sampling, stepper);
}

}  // namespace zona::beam
