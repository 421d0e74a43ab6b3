#include "beam/time/arkode_equations.h"

namespace zona::beam {

ArkodeEquations::ArkodeEquations(const BeamSystem& system, const SupportMotion& motion,
                                 const FrequencySpan& span)
    : beam_(transient_beam(system, span)),
      size_(system.size()),
      memories_(beam_.memories()),
      observation_(system.observation),
      motion_(motion),
      support_velocity_(motion),
      drag_(beam_),
      mass_factor_(beam_.mass),
      kick_(beam_.support_mass),
      operator_(system.size()),
      displacement_(Eigen::VectorXd::Zero(system.size())),
      velocity_(displacement_),
      acceleration_(displacement_),
      product_(displacement_),
      remembered_(displacement_) {
  mass_factor_.solve_in_place(kick_);
}

void ArkodeEquations::rates(double time, const View& state, View rates) {
  const int n = size_;
  const double support = support_velocity_.at(time);
  displacement_ = state.head(n);
  velocity_ = state.segment(n, n);
  beam_.stiffness.multiply(displacement_, acceleration_);
  acceleration_ = -acceleration_ - smooth_acceleration(motion_, time) * beam_.support_mass;
  if (beam_.is_damped) {
    beam_.damping.multiply(velocity_, product_);
    acceleration_ -= product_ + support * beam_.support_damping;
  }
  const Eigen::Map<const Eigen::MatrixXd> memory(state.data() + 2 * n, n, memories_);
  const Eigen::Map<const Eigen::ArrayXd> support_memory(state.data() + (2 + memories_) * n,
                                                        memories_);
  for (std::size_t k = 0; k < beam_.basis.size(); ++k) {
    remembered_.noalias() = memory * beam_.weight.col(k);
    beam_.basis[k].multiply(remembered_, product_);
    acceleration_ -= product_ + beam_.weight.col(k).dot(support_memory.matrix()) * beam_.support[k];
  }
  if (drag_.acts()) {
    drag_.linearise(velocity_, support);
    product_.setZero();
    drag_.add_force(velocity_, support, product_);
    acceleration_ -= product_;
  }
  mass_factor_.solve_in_place(acceleration_);
  rates.head(n) = velocity_;
  rates.segment(n, n) = acceleration_;
  for (int j = 0; j < memories_; ++j)
    rates.segment((2 + j) * n, n) = velocity_ - beam_.rate(j) * memory.col(j);
  rates.tail(memories_) = (support - beam_.rate * support_memory).matrix();
}

void ArkodeEquations::solve_newton(double gamma, const View& right_side, View solution) {
  // q = a + gamma v, (1 + gamma p_j) y_j = b_j + gamma v, so that
  // (M + gamma C + gamma^2 K + gamma^2 sum_jk w_jk/(1 + gamma p_j) B_k) v
  //     = M b - gamma K a - gamma sum_k B_k sum_j w_jk b_j/(1 + gamma p_j) - ... z_j
  const int n = size_;
  const Eigen::ArrayXd kept = 1 / (1 + gamma * beam_.rate);
  if (gamma != gamma_) {
    operator_.combine(1, beam_.mass, gamma * gamma, beam_.stiffness);
    if (beam_.is_damped) operator_.accumulate(gamma, beam_.damping);
    for (std::size_t k = 0; k < beam_.basis.size(); ++k)
      operator_.accumulate(gamma * gamma * (beam_.weight.col(k).array() * kept).sum(),
                           beam_.basis[k]);
    operator_factor_.factorise(operator_);
    gamma_ = gamma;
  }
  displacement_ = right_side.head(n);
  velocity_ = right_side.segment(n, n);
  const Eigen::Map<const Eigen::MatrixXd> memory(right_side.data() + 2 * n, n, memories_);
  const Eigen::ArrayXd support_memory = kept * right_side.tail(memories_).array();
  beam_.mass.multiply(velocity_, acceleration_);
  beam_.stiffness.multiply(displacement_, product_);
  acceleration_ -= gamma * product_;
  for (std::size_t k = 0; k < beam_.basis.size(); ++k) {
    const Eigen::VectorXd weight = (beam_.weight.col(k).array() * kept).matrix();
    remembered_.noalias() = memory * weight;
    beam_.basis[k].multiply(remembered_, product_);
    acceleration_ -=
        gamma * (product_ + beam_.weight.col(k).dot(support_memory.matrix()) * beam_.support[k]);
  }
  operator_factor_.solve_in_place(acceleration_);
  // In this order, because solution and right side may share memory.
  for (int j = 0; j < memories_; ++j)
    solution.segment((2 + j) * n, n) = kept(j) * (memory.col(j) + gamma * acceleration_);
  solution.tail(memories_) = support_memory.matrix();
  solution.head(n) = displacement_ + gamma * acceleration_;
  solution.segment(n, n) = acceleration_;
}

void ArkodeEquations::kick(double velocity_jump, View state) {
  state.segment(size_, size_) -= velocity_jump * kick_;
  support_velocity_.kick(velocity_jump);
}

RelativeMotion ArkodeEquations::observed(double time, const View& state) {
  Eigen::VectorXd derivative(state.size());
  rates(time, state, View(derivative.data(), derivative.size()));
  return {observation_.dot(state.head(size_)), observation_.dot(state.segment(size_, size_)),
          observation_.dot(derivative.segment(size_, size_))};
}

}  // namespace zona::beam
