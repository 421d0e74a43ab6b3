#include "beam/modal_stepper.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <utility>

#include "beam/require.h"

namespace zona::beam {

ModalOscillators oscillators(const NaturalModes& modes, int count, double alpha, double beta) {
  const Eigen::ArrayXd angular_frequency = modes.angular_frequency.head(count);
  return {angular_frequency, decay_rate(angular_frequency, alpha, beta),
          modes.participation.head(count), modes.observed.head(count)};
}

ModalStepper::ModalStepper(ModalOscillators modes, const SupportMotion& motion,
                           double sampling_step)
    : motion_(motion),
      sampling_step_(sampling_step),
      modes_(std::move(modes)),
      sampling_transition_(transition(modes_.angular_frequency, modes_.decay_rate, sampling_step)),
      displacement_(Eigen::ArrayXd::Zero(modes_.angular_frequency.size())),
      velocity_(displacement_),
      previous_(displacement_) {
  if (const auto* sine = std::get_if<SineMotion>(&motion)) find_steady_response(*sine);
}

void ModalStepper::find_steady_response(const SineMotion& sine) {
  // x'' + 2 sigma x' + omega^2 x = participation A w^2 sin(w t)
  const double w = sine.angular_frequency;
  steady_frequency_ = w;
  steady_.resize(modes_.angular_frequency.size());
  for (Eigen::Index n = 0; n < steady_.size(); ++n) {
    const double omega = modes_.angular_frequency(n);
    const std::complex<double> impedance(omega * omega - w * w, 2 * modes_.decay_rate(n) * w);
    require(std::abs(impedance) > 1e-9 * w * w,
            fmt::format("modal superposition: the support moves at {} rad/s, the frequency of mode "
                        "{}; change the frequency by a part in a million or add damping",
                        w, n + 1));
    steady_(n) = modes_.participation(n) * sine.amplitude * w * w / impedance;
  }
}

void ModalStepper::add_steady_response(double time, double sign) {
  if (steady_.size() == 0) return;
  const std::complex<double> phase = std::polar(1., steady_frequency_ * time);
  displacement_ += sign * (steady_ * phase).imag();
  velocity_ += sign * steady_frequency_ * (steady_ * phase).real();
}

void ModalStepper::apply(const OscillatorTransition& span) {
  previous_ = displacement_;
  displacement_ = span.xx * previous_ + span.xv * velocity_;
  velocity_ = span.vx * previous_ + span.vv * velocity_;
}

void ModalStepper::advance(double from, double to) {
  add_steady_response(from, -1);
  const double span = to - from;
  // A whole sampling step, up to the rounding of the sample times, uses the prepared operator.
  if (std::abs(span - sampling_step_) < 1e-9 * sampling_step_)
    apply(sampling_transition_);
  else
    apply(transition(modes_.angular_frequency, modes_.decay_rate, span));
  add_steady_response(to, 1);
  time_ = to;
}

void ModalStepper::kick(double time, double velocity_jump) {
  velocity_ -= velocity_jump * modes_.participation;
  time_ = time;
}

RelativeMotion ModalStepper::observed() const {
  const Eigen::ArrayXd acceleration = -modes_.angular_frequency.square() * displacement_ -
                                      2 * modes_.decay_rate * velocity_ -
                                      smooth_acceleration(motion_, time_) * modes_.participation;
  return {(modes_.observed * displacement_).sum(), (modes_.observed * velocity_).sum(),
          (modes_.observed * acceleration).sum()};
}

}  // namespace zona::beam
