#include "beam/transient_beam.h"

#include <cmath>

#include "beam/relaxation.h"
#include "beam/require.h"

namespace zona::beam {
namespace {

constexpr double kPi = 3.14159265358979323846;

void add_constant_bath(const Immersion& bath, TransientBeam& beam) {
  for (std::size_t k = 0; k < bath.radius.size(); ++k) {
    const std::complex<double> load =
        viscous_load(bath.liquid, bath.radius[k], {0, bath.angular_frequency});
    beam.mass.accumulate(load.imag() / bath.angular_frequency, bath.share[k].matrix);
    beam.support_mass += load.imag() / bath.angular_frequency * bath.share[k].support;
    beam.damping.accumulate(load.real(), bath.share[k].matrix);
    beam.support_damping += load.real() * bath.share[k].support;
  }
}

/// One column of weights per node of the radius.
void add_bath_with_memory(const Immersion& bath, const RateLadder& ladder, TransientBeam& beam) {
  const double scale = 4 * kPi * bath.liquid.viscosity;
  const Eigen::Index first = beam.weight.cols();
  const auto nodes = static_cast<Eigen::Index>(bath.radius.size());
  beam.weight.conservativeResize(ladder.rate.size(), first + nodes);
  for (Eigen::Index k = 0; k < nodes; ++k) {
    const Distributed& share = bath.share[k];
    const Relaxation load = viscous_relaxation(ladder, bath.liquid, bath.radius[k]);
    // s/(s + p) of the velocity is the velocity less p y.
    const double at_once = scale * (load.instant + load.weight.sum());
    beam.damping.accumulate(at_once, share.matrix);
    beam.support_damping += at_once * share.support;
    beam.mass.accumulate(scale * load.slope, share.matrix);
    beam.support_mass += scale * load.slope * share.support;
    beam.weight.col(first + k) = -scale * ladder.rate * load.weight;
    beam.basis.push_back(share.matrix);
    beam.support.push_back(share.support);
  }
}

/// The stiffness takes y itself, as s/(s + p) of the displacement.
void add_loss(const BeamSystem& system, const RateLadder& ladder, TransientBeam& beam) {
  const Relaxation modulus = loss_relaxation(ladder, system.loss_factor, system.loss_frequency);
  beam.stiffness.combine(modulus.instant, system.stiffness, 0, system.stiffness);
  beam.damping.accumulate(modulus.slope, system.stiffness);
  beam.weight.conservativeResize(ladder.rate.size(), beam.weight.cols() + 1);
  beam.weight.rightCols(1) = modulus.weight.matrix();
  beam.basis.push_back(system.stiffness);
  beam.support.push_back(Eigen::VectorXd::Zero(system.size()));
}

}  // namespace

TransientBeam transient_beam(const BeamSystem& system, const FrequencySpan& span) {
  const Immersion& bath = system.immersion;
  require(!(bath.acts() && bath.model == BathModel::per_mode),
          "bath: per_mode has a meaning for modal superposition only; choose it, or another model "
          "of the bath");
  TransientBeam beam;
  beam.mass = system.mass;
  beam.stiffness = system.stiffness;
  beam.damping = SymmetricBand(system.size());
  beam.damping.combine(system.damping_alpha, system.mass, system.damping_beta, system.stiffness);
  beam.support_mass = system.support_mass;
  beam.support_damping = Eigen::VectorXd::Zero(system.size());
  beam.drag = bath.drag;
  const bool has_memory = bath.acts() && bath.model == BathModel::frequency;
  RateLadder ladder;
  if (has_memory || system.loss_factor > 0) ladder = RateLadder::over(span.lowest, span.highest);
  beam.rate = ladder.rate;
  beam.weight.resize(beam.rate.size(), 0);
  if (bath.acts()) {
    beam.mass.accumulate(1, bath.displaced.matrix);
    beam.support_mass += bath.displaced.support;
    if (has_memory)
      add_bath_with_memory(bath, ladder, beam);
    else
      add_constant_bath(bath, beam);
  }
  if (system.loss_factor > 0) add_loss(system, ladder, beam);
  beam.is_damped = system.damping_alpha != 0 || system.damping_beta != 0 || bath.acts() ||
                   system.loss_factor > 0;
  return beam;
}

double QuadraticDrag::velocity_at(const QuadraturePoint& point, const Eigen::VectorXd& velocity,
                                  double support_velocity) const {
  double value = point.rigid * support_velocity;
  for (int i = 0; i < QuadraturePoint::dofs; ++i)
    if (point.dof[i] != QuadraturePoint::held) value += point.shape[i] * velocity(point.dof[i]);
  return value;
}

void QuadraticDrag::linearise(const Eigen::VectorXd& velocity, double support_velocity) {
  coefficient_.resize(points_->size());
  matrix_ = SymmetricBand(matrix_.size());
  for (std::size_t p = 0; p < points_->size(); ++p) {
    const QuadraturePoint& point = (*points_)[p];
    coefficient_[p] = point.weight * std::abs(velocity_at(point, velocity, support_velocity));
    for (int i = 0; i < QuadraturePoint::dofs; ++i)
      for (int j = 0; j <= i; ++j) {
        if (point.dof[i] == QuadraturePoint::held || point.dof[j] == QuadraturePoint::held)
          continue;
        matrix_.add(point.dof[i], point.dof[j], coefficient_[p] * point.shape[i] * point.shape[j]);
      }
  }
}

void QuadraticDrag::add_force(const Eigen::VectorXd& velocity, double support_velocity,
                              Eigen::VectorXd& force) const {
  for (std::size_t p = 0; p < points_->size(); ++p) {
    const QuadraturePoint& point = (*points_)[p];
    const double value = coefficient_[p] * velocity_at(point, velocity, support_velocity);
    for (int i = 0; i < QuadraturePoint::dofs; ++i)
      if (point.dof[i] != QuadraturePoint::held) force(point.dof[i]) += value * point.shape[i];
  }
}

void SupportVelocity::advance(double to) {
  value_ = at(to);
}

double SupportVelocity::at(double time) const {
  return std::holds_alternative<SineMotion>(*motion_) ? velocity(*motion_, time) : value_;
}

}  // namespace zona::beam
