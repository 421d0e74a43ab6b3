#include "beam/arkode_equations.h"

namespace zona::beam {

ArkodeEquations::ArkodeEquations(const BeamSystem& system, const SupportMotion& motion)
    : system_(system),
      motion_(motion),
      mass_factor_(system.mass),
      kick_(system.support_mass),
      operator_(system.size()),
      displacement_(Eigen::VectorXd::Zero(system.size())),
      velocity_(displacement_),
      acceleration_(displacement_),
      product_(displacement_) {
  mass_factor_.solve_in_place(kick_);
}

void ArkodeEquations::rates(double time, const View& state, View rates) {
  const int n = system_.size();
  velocity_ = state.tail(n);
  displacement_ = state.head(n) + system_.damping_beta * velocity_;
  system_.stiffness.multiply(displacement_, acceleration_);
  acceleration_ = -acceleration_ - smooth_acceleration(motion_, time) * system_.support_mass;
  mass_factor_.solve_in_place(acceleration_);
  rates.head(n) = velocity_;
  rates.tail(n) = acceleration_ - system_.damping_alpha * velocity_;
}

void ArkodeEquations::solve_newton(double gamma, const View& right_side, View solution) {
  // q = a + gamma v,  (M + gamma C + gamma^2 K) v = M b - gamma K a
  const int n = system_.size();
  if (gamma != gamma_) {
    operator_.combine(1 + gamma * system_.damping_alpha, system_.mass,
                      gamma * (system_.damping_beta + gamma), system_.stiffness);
    operator_factor_.factorise(operator_);
    gamma_ = gamma;
  }
  displacement_ = right_side.head(n);
  velocity_ = right_side.tail(n);
  system_.mass.multiply(velocity_, acceleration_);
  system_.stiffness.multiply(displacement_, product_);
  acceleration_ -= gamma * product_;
  operator_factor_.solve_in_place(acceleration_);
  solution.head(n) = displacement_ + gamma * acceleration_;
  solution.tail(n) = acceleration_;
}

void ArkodeEquations::kick(double velocity_jump, View state) const {
  state.tail(system_.size()) -= velocity_jump * kick_;
}

RelativeMotion ArkodeEquations::observed(double time, const View& state) {
  const int n = system_.size();
  Eigen::VectorXd derivative(2 * n);
  rates(time, state, View(derivative.data(), 2 * n));
  return {system_.observation.dot(state.head(n)), system_.observation.dot(state.tail(n)),
          system_.observation.dot(derivative.tail(n))};
}

}  // namespace zona::beam
