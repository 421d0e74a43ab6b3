#include "beam/time/newmark_stepper.h"

#include <algorithm>
#include <cmath>

namespace zona::beam {

NewmarkStepper::NewmarkStepper(const BeamSystem& system, const SupportMotion& motion, double step,
                               const FrequencySpan& span)
    : beam_(transient_beam(system, span)),
      observation_(system.observation),
      motion_(motion),
      greatest_step_(step),
      support_velocity_(motion),
      drag_(beam_),
      memory_(Eigen::MatrixXd::Zero(system.size(), beam_.memories())),
      support_memory_(Eigen::ArrayXd::Zero(beam_.memories())),
      operator_(system.size()),
      mass_factor_(beam_.mass),
      kick_(beam_.support_mass),
      displacement_(Eigen::VectorXd::Zero(system.size())),
      velocity_(displacement_),
      acceleration_(displacement_),
      predicted_(displacement_),
      remembered_(displacement_),
      product_(displacement_) {
  mass_factor_.solve_in_place(kick_);
  compute_acceleration(0);
}

void NewmarkStepper::set_state(double time, const Eigen::VectorXd& displacement,
                               const Eigen::VectorXd& velocity) {
  displacement_ = displacement;
  velocity_ = velocity;
  compute_acceleration(time);
}

void NewmarkStepper::factorise(double step) {
  step_ = step;
  operator_.combine(1, beam_.mass, step * step / 4, beam_.stiffness);
  if (beam_.is_damped) operator_.accumulate(step / 2, beam_.damping);
  if (beam_.memories() > 0) {
    // y' = q' - p y with a velocity that varies linearly from v0 to v1 in a step.
    const Eigen::ArrayXd z = beam_.rate * step;
    const Eigen::ArrayXd mean = -(-z).unaryExpr([](double x) { return std::expm1(x); }) / z;
    kept_ = (-z).exp();
    // (1 - mean) / z cancels for small z, where the series is accurate.
    from_new_ = (z < 1e-3).select(step * (0.5 - z / 6 + z * z / 24), step * (1 - mean) / z);
    from_old_ = step * mean - from_new_;
    for (std::size_t k = 0; k < beam_.basis.size(); ++k) {
      const double share = (beam_.weight.col(k).array() * from_new_).sum();
      operator_.accumulate(step / 2 * share, beam_.basis[k]);
    }
  }
  if (!drag_.acts()) operator_factor_.factorise(operator_);
}

void NewmarkStepper::compute_force(double time, const Eigen::VectorXd& displacement,
                                   const Eigen::VectorXd& velocity, Eigen::VectorXd& force) {
  beam_.stiffness.multiply(displacement, force);
  force = -force - smooth_acceleration(motion_, time) * beam_.support_mass;
  if (!beam_.is_damped) return;
  beam_.damping.multiply(velocity, product_);
  force -= product_ + support_velocity_.now() * beam_.support_damping;
  for (std::size_t k = 0; k < beam_.basis.size(); ++k) {
    const auto weight = beam_.weight.col(k);
    remembered_.noalias() = memory_ * weight;
    beam_.basis[k].multiply(remembered_, product_);
    force -= product_ + weight.dot(support_memory_.matrix()) * beam_.support[k];
  }
}

void NewmarkStepper::compute_acceleration(double time) {
  compute_force(time, displacement_, velocity_, acceleration_);
  if (drag_.acts()) {
    drag_.linearise(velocity_, support_velocity_.now());
    product_.setZero();
    drag_.add_force(velocity_, support_velocity_.now(), product_);
    acceleration_ -= product_;
  }
  mass_factor_.solve_in_place(acceleration_);
}

void NewmarkStepper::advance_memories(double support_velocity, const Eigen::VectorXd& velocity) {
  for (int j = 0; j < beam_.memories(); ++j)
    memory_.col(j) = kept_(j) * memory_.col(j) + from_old_(j) * velocity_ + from_new_(j) * velocity;
  support_memory_ =
      kept_ * support_memory_ + from_old_ * support_velocity + from_new_ * support_velocity_.now();
}

void NewmarkStepper::include_drag(const Eigen::VectorXd& velocity) {
  drag_.linearise(velocity, support_velocity_.now());
  SymmetricBand with_drag = operator_;
  with_drag.accumulate(step_ / 2, drag_.matrix());
  operator_factor_.factorise(with_drag);
}

void NewmarkStepper::step_to(double time) {
  const double h = step_;
  displacement_ += h * velocity_ + h * h / 4 * acceleration_;
  predicted_ = velocity_ + h / 2 * acceleration_;
  const double support_before = support_velocity_.now();
  support_velocity_.advance(time);
  if (beam_.memories() > 0) advance_memories(support_before, predicted_);
  // The drag is linear in the velocity if the speed |v| is given. The first pass uses the speed at
  // the start of the step, the second one corrects it; extrapolation would keep modes alive that a
  // step cannot resolve.
  const int passes = drag_.acts() ? 2 : 1;
  for (int pass = 0; pass < passes; ++pass) {
    if (drag_.acts()) include_drag(velocity_);
    compute_force(time, displacement_, predicted_, acceleration_);
    if (drag_.acts()) {
      product_.setZero();
      drag_.add_force(predicted_, support_velocity_.now(), product_);
      acceleration_ -= product_;
    }
    operator_factor_.solve_in_place(acceleration_);
    velocity_ = predicted_ + h / 2 * acceleration_;
  }
  displacement_ += h * h / 4 * acceleration_;
  for (int j = 0; j < beam_.memories(); ++j) memory_.col(j) += h / 2 * from_new_(j) * acceleration_;
}

void NewmarkStepper::advance(double from, double to) {
  // The tolerance keeps rounding of sample times from adding a step or a factorisation.
  const double span = to - from;
  const int steps = std::max(1, static_cast<int>(std::ceil(span / greatest_step_ - 1e-6)));
  const double step = span / steps;
  if (std::abs(step - step_) > 1e-9 * step) factorise(step);
  for (int i = 1; i <= steps; ++i) step_to(from + i * step);
}

void NewmarkStepper::kick(double time, double velocity_jump) {
  velocity_ -= velocity_jump * kick_;
  support_velocity_.kick(velocity_jump);
  compute_acceleration(time);
}

RelativeMotion NewmarkStepper::observed() const {
  return {observation_.dot(displacement_), observation_.dot(velocity_),
          observation_.dot(acceleration_)};
}

double NewmarkStepper::energy() const {
  Eigen::VectorXd product(displacement_.size());
  beam_.mass.multiply(velocity_, product);
  double energy = velocity_.dot(product) / 2;
  beam_.stiffness.multiply(displacement_, product);
  energy += displacement_.dot(product) / 2;
  return energy;
}

}  // namespace zona::beam
