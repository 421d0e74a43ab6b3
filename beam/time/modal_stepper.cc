#include "beam/time/modal_stepper.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "beam/algebra/require.h"

namespace zona::beam {

ModalOscillators oscillators(const NaturalModes& modes, int count, double alpha, double beta) {
  const Eigen::ArrayXd angular_frequency = modes.angular_frequency.head(count);
  return {angular_frequency, decay_rate(angular_frequency, alpha, beta),
          modes.participation.head(count), modes.observed.head(count)};
}

namespace {

/// Loads of the liquids on one mode at one frequency, per modal mass.
struct ModalLiquids {
  double mass = 0;          ///< [-]
  double drag = 0;          ///< [1/s]
  double support_mass = 0;  ///< [-]
  double support_drag = 0;  ///< [1/s]
};

class LiquidsOfMode {
 public:
  LiquidsOfMode(const LiquidLoads& liquids, const NaturalModes& modes, int mode)
      : liquids_(liquids) {
    const Eigen::VectorXd shape = modes.shape.col(mode);
    displaced_ = project(liquids.displaced, shape);
    for (const ViscousLoad& load : liquids.viscous) share_.push_back(project(load.share, shape));
  }

  ModalLiquids at(double omega) const {
    ModalLiquids sum{displaced_.first, 0, displaced_.second, 0};
    for (std::size_t k = 0; k < share_.size(); ++k) {
      const ViscousLoad& kind = liquids_.viscous[k];
      const std::complex<double> load =
          viscous_load(kind.flow, kind.liquid, kind.radius, {0, omega});
      sum.mass += load.imag() / omega * share_[k].first;
      sum.drag += load.real() * share_[k].first;
      sum.support_mass += load.imag() / omega * share_[k].second;
      sum.support_drag += load.real() * share_[k].second;
    }
    return sum;
  }

 private:
  static std::pair<double, double> project(const Distributed& load, const Eigen::VectorXd& shape) {
    Eigen::VectorXd product(shape.size());
    load.matrix.multiply(shape, product);
    return {shape.dot(product), shape.dot(load.support)};
  }

  const LiquidLoads& liquids_;
  std::pair<double, double>
      displaced_;  ///< products of the shape with itself and with rigid motion
  std::vector<std::pair<double, double>> share_;
};

}  // namespace

ModalOscillators oscillators(const BeamSystem& system, const NaturalModes& modes, int count) {
  const LiquidLoads& liquids = system.liquids;
  ModalOscillators result = oscillators(modes, count, system.damping_alpha, system.damping_beta);
  if (liquids.act()) {
    result.drag_participation.resize(count);
    for (int n = 0; n < count; ++n) {
      const LiquidsOfMode of_mode(liquids, modes, n);
      const double in_vacuum = modes.angular_frequency(n);
      double omega = in_vacuum;
      ModalLiquids load = of_mode.at(omega);
      // Added mass varies slowly with frequency: every iteration gains more than a digit.
      for (int round = 0; round < 100; ++round) {
        const double next = in_vacuum / std::sqrt(1 + load.mass);
        load = of_mode.at(next);
        if (std::abs(next - omega) < 1e-14 * omega) break;
        omega = next;
      }
      const double inertia = 1 + load.mass;
      result.angular_frequency(n) = in_vacuum / std::sqrt(inertia);
      result.decay_rate(n) = (result.decay_rate(n) + load.drag / 2) / inertia;
      result.participation(n) = (result.participation(n) + load.support_mass) / inertia;
      result.drag_participation(n) = load.support_drag / inertia;
    }
  }
  result.decay_rate += system.loss_factor / 2 * result.angular_frequency;
  return result;
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
    std::complex<double> force = modes_.participation(n) * w * w;
    if (modes_.drag_participation.size() > 0)
      force -= std::complex<double>(0, modes_.drag_participation(n) * w);
    steady_(n) = sine.amplitude * force / impedance;
  }
}

void ModalStepper::add_steady_response(double time, double sign) {
  if (steady_.size() == 0) return;
  const std::complex<double> phase = std::polar(1., steady_frequency_ * time);
  displacement_ += sign * (steady_ * phase).imag();
  velocity_ += sign * steady_frequency_ * (steady_ * phase).real();
}

void ModalStepper::apply(const OscillatorTransition& span) {
  // Constant velocity of the support shifts the equilibrium of the modes by the drag.
  const bool is_dragged = modes_.drag_participation.size() > 0 && support_velocity_ != 0;
  const Eigen::ArrayXd rest = is_dragged
                                  ? Eigen::ArrayXd(-support_velocity_ * modes_.drag_participation /
                                                   modes_.angular_frequency.square())
                                  : Eigen::ArrayXd();
  if (is_dragged) displacement_ -= rest;
  previous_ = displacement_;
  displacement_ = span.xx * previous_ + span.xv * velocity_;
  velocity_ = span.vx * previous_ + span.vv * velocity_;
  if (is_dragged) displacement_ += rest;
}

void ModalStepper::advance(double from, double to) {
  add_steady_response(from, -1);
  const double span = to - from;
  // A full sampling step, up to rounding of the sample times, uses the precomputed operator.
  if (std::abs(span - sampling_step_) < 1e-9 * sampling_step_)
    apply(sampling_transition_);
  else
    apply(transition(modes_.angular_frequency, modes_.decay_rate, span));
  add_steady_response(to, 1);
  time_ = to;
}

void ModalStepper::kick(double time, double velocity_jump) {
  velocity_ -= velocity_jump * modes_.participation;
  if (steady_.size() == 0) support_velocity_ += velocity_jump;
  time_ = time;
}

RelativeMotion ModalStepper::observed() const {
  Eigen::ArrayXd acceleration = -modes_.angular_frequency.square() * displacement_ -
                                2 * modes_.decay_rate * velocity_ -
                                smooth_acceleration(motion_, time_) * modes_.participation;
  if (modes_.drag_participation.size() > 0) {
    const double support = steady_.size() == 0 ? support_velocity_ : velocity(motion_, time_);
    acceleration -= support * modes_.drag_participation;
  }
  return {(modes_.observed * displacement_).sum(), (modes_.observed * velocity_).sum(),
          (modes_.observed * acceleration).sum()};
}

}  // namespace zona::beam
