#include "beam/system/transient_beam.h"

#include <algorithm>
#include <cmath>

#include "beam/algebra/require.h"
#include "beam/system/relaxation.h"

namespace zona::beam {
namespace {

/// Adds the mass and drag of a load at its one frequency.
void add_constant_load(const ViscousLoad& load, TransientBeam& beam) {
  const std::complex<double> value =
      viscous_load(load.flow, load.liquid, load.radius, {0, load.angular_frequency});
  const double mass = value.imag() / load.angular_frequency;
  beam.mass.accumulate(mass, load.share.matrix);
  beam.support_mass += mass * load.share.support;
  beam.damping.accumulate(value.real(), load.share.matrix);
  beam.support_damping += value.real() * load.share.support;
}

/// Adds a load with memory, as one more column of weights.
void add_load_with_memory(const ViscousLoad& load, const RateLadder& ladder, TransientBeam& beam) {
  const Relaxation relaxation = viscous_relaxation(load.flow, ladder, load.liquid, load.radius);
  // s/(s + p) times the velocity is the velocity minus p y.
  const double immediate = relaxation.instant + relaxation.weight.sum();
  beam.damping.accumulate(immediate, load.share.matrix);
  beam.support_damping += immediate * load.share.support;
  beam.mass.accumulate(relaxation.slope, load.share.matrix);
  beam.support_mass += relaxation.slope * load.share.support;
  beam.weight.conservativeResize(Eigen::NoChange, beam.weight.cols() + 1);
  beam.weight.rightCols(1) = -(ladder.rate * relaxation.weight).matrix();
  beam.basis.push_back(load.share.matrix);
  beam.support.push_back(load.share.support);
}

/// Rates for the loads with memory; empty without such loads.
RateLadder ladder_for(const BeamSystem& system, const FrequencySpan& span) {
  const auto& loads = system.liquids.viscous;
  const bool has_bore = std::any_of(loads.begin(), loads.end(), [](const ViscousLoad& load) {
    return load.flow == Flow::within;
  });
  if (has_bore) return RateLadder::over(span.lowest, span.highest, 0.5);
  if (system.liquids.has_bath(BathModel::frequency) || system.loss_factor > 0)
    return RateLadder::over(span.lowest, span.highest);
  return {};
}

/// Adds the loss factor. Its Maxwell elements act on y itself, which is s/(s + p) times the
/// displacement.
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
  const LiquidLoads& liquids = system.liquids;
  require(!liquids.has_bath(BathModel::per_mode),
          "bath: the model per_mode works with modal superposition only; choose that integrator, "
          "or another model of the bath");
  TransientBeam beam;
  beam.mass = system.mass;
  beam.stiffness = system.stiffness;
  beam.damping = SymmetricBand(system.size());
  beam.damping.combine(system.damping_alpha, system.mass, system.damping_beta, system.stiffness);
  beam.support_mass = system.support_mass;
  beam.support_damping = Eigen::VectorXd::Zero(system.size());
  beam.drag = liquids.drag;
  const RateLadder ladder = ladder_for(system, span);
  beam.rate = ladder.rate;
  beam.weight.resize(beam.rate.size(), 0);
  if (liquids.act()) {
    beam.mass.accumulate(1, liquids.displaced.matrix);
    beam.support_mass += liquids.displaced.support;
  }
  for (const ViscousLoad& load : liquids.viscous) {
    if (load.model == BathModel::constant)
      add_constant_load(load, beam);
    else
      add_load_with_memory(load, ladder, beam);
  }
  if (system.loss_factor > 0) add_loss(system, ladder, beam);
  beam.is_damped = system.damping_alpha != 0 || system.damping_beta != 0 || liquids.act() ||
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
