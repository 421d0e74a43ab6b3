#include "beam/newmark_stepper.h"

#include <algorithm>
#include <cmath>

namespace zona::beam {

NewmarkStepper::NewmarkStepper(const BeamSystem& system, const SupportMotion& motion, double step)
    : system_(system),
      motion_(motion),
      greatest_step_(step),
      operator_(system.size()),
      mass_factor_(system.mass),
      kick_(system.support_mass),
      displacement_(Eigen::VectorXd::Zero(system.size())),
      velocity_(displacement_),
      acceleration_(displacement_),
      combined_(displacement_),
      product_(displacement_) {
  mass_factor_.solve_in_place(kick_);
  solve_acceleration(mass_factor_, 0, displacement_, velocity_, acceleration_);
}

void NewmarkStepper::set_state(double time, const Eigen::VectorXd& displacement,
                               const Eigen::VectorXd& velocity) {
  displacement_ = displacement;
  velocity_ = velocity;
  solve_acceleration(mass_factor_, time, displacement_, velocity_, acceleration_);
}

void NewmarkStepper::factorise(double step) {
  // M + h/2 C + h^2/4 K with C = alpha M + beta K.
  operator_.combine(1 + step / 2 * system_.damping_alpha, system_.mass,
                    step / 2 * system_.damping_beta + step * step / 4, system_.stiffness);
  operator_factor_.factorise(operator_);
  step_ = step;
}

void NewmarkStepper::solve_acceleration(const BandFactor& factor, double time,
                                        const Eigen::VectorXd& displacement,
                                        const Eigen::VectorXd& velocity,
                                        Eigen::VectorXd& acceleration) {
  combined_ = displacement + system_.damping_beta * velocity;
  system_.stiffness.multiply(combined_, acceleration);
  acceleration = -acceleration - smooth_acceleration(motion_, time) * system_.support_mass;
  if (system_.damping_alpha != 0) {
    system_.mass.multiply(velocity, product_);
    acceleration -= system_.damping_alpha * product_;
  }
  factor.solve_in_place(acceleration);
}

void NewmarkStepper::step_to(double time) {
  displacement_ += step_ * velocity_ + step_ * step_ / 4 * acceleration_;
  velocity_ += step_ / 2 * acceleration_;
  solve_acceleration(operator_factor_, time, displacement_, velocity_, acceleration_);
  displacement_ += step_ * step_ / 4 * acceleration_;
  velocity_ += step_ / 2 * acceleration_;
}

void NewmarkStepper::advance(double from, double to) {
  // The slack lets rounding of the sample times neither add a step nor factorise again.
  const double span = to - from;
  const int steps = std::max(1, static_cast<int>(std::ceil(span / greatest_step_ - 1e-6)));
  const double step = span / steps;
  if (std::abs(step - step_) > 1e-9 * step) factorise(step);
  for (int i = 1; i <= steps; ++i) step_to(from + i * step);
}

void NewmarkStepper::kick(double time, double velocity_jump) {
  velocity_ -= velocity_jump * kick_;
  solve_acceleration(mass_factor_, time, displacement_, velocity_, acceleration_);
}

RelativeMotion NewmarkStepper::observed() const {
  return {system_.observation.dot(displacement_), system_.observation.dot(velocity_),
          system_.observation.dot(acceleration_)};
}

double NewmarkStepper::energy() const {
  Eigen::VectorXd product(displacement_.size());
  system_.mass.multiply(velocity_, product);
  double energy = velocity_.dot(product) / 2;
  system_.stiffness.multiply(displacement_, product);
  energy += displacement_.dot(product) / 2;
  return energy;
}

}  // namespace zona::beam
