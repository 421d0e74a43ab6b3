#include "studies/kinds/material_point/events.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace zona::studies {

namespace {

/// Null, or the step, strain and stress.
template <class Event>
nlohmann::json described(const std::optional<Event>& event) {
  if (!event) return {};
  return {{"step", event->step},
          {"strain", event->sample.strain},
          {"stress", event->sample.stress},
          {"equivalent_stress", mpm::equivalent_stress(event->sample.stress)}};
}

/// Between a direction and that of the largest principal stress [rad].
double angle_to_largest(const Eigen::Vector3d& direction, const mpm::SymmetricTensor& s) {
  Eigen::Matrix3d stress;
  stress << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(stress);
  return std::acos(std::min(1.0, std::abs(direction.dot(principal.eigenvectors().col(2)))));
}

}  // namespace

void PointEvents::add(long step, const mpm::PointSample& sample, double stress_left) {
  for (int c = 0; c < 6; ++c) {
    work_ += (c < 3 ? 0.5 : 1.0) * (last_.stress[c] + sample.stress[c]) *
             (sample.strain[c] - last_.strain[c]);
  }
  const double equivalent = mpm::equivalent_stress(sample.stress);
  if (!yield_ && (sample.internal > 0 || sample.left < 1)) yield_ = {step, sample};
  if (equivalent > largest_) peak_ = {step, sample};
  if (!surface_ && sample.surface.present()) {
    before_surface_ = {step - 1, last_};
    surface_ = {step, sample};
  }
  if (!failure_ && sample.left == 0) failure_ = {step, sample};
  largest_ = std::max(largest_, equivalent);
  largest_left_ = std::max(largest_left_, stress_left);
  last_ = sample;
}

/// The state is the last one before the surface: where the opening snaps back, nothing is left of
/// the stress after that step.
nlohmann::json PointEvents::bifurcation() const {
  if (!surface_) return {};
  const auto& normal = surface_->sample.normal;
  nlohmann::json r = described(before_surface_);
  r["normal"] = {normal.x(), normal.y(), normal.z()};
  r["angle_to_largest_principal_stress"] = angle_to_largest(normal, before_surface_->sample.stress);
  r["tensile_strength"] = surface_->sample.surface.tensile_strength;
  r["reference_traction"] = surface_->sample.surface.reference_traction;
  r["effective_length"] = surface_->sample.effective_length;
  r["failed_in_the_same_step"] = surface_->sample.left == 0;
  return r;
}

nlohmann::json PointEvents::results() const {
  nlohmann::json r;
  r["yield"] = described(yield_);
  r["peak"] = described(peak_);
  r["bifurcation"] = bifurcation();
  r["failure"] = described(failure_);
  r["end"] = {{"strain", last_.strain}, {"stress", last_.stress}, {"integrity", last_.left}};
  r["work"] = work_;
  r["stored_energy"] = last_.stored_energy;
  r["dissipated"] = work_ - last_.stored_energy;
  r["flow_dissipation"] = last_.flow_dissipation;
  r["opening_dissipation"] = last_.opening_dissipation;
  r["resolved_opening_energy"] = last_.resolved_energy;
  r["largest_stress_of_free_components"] = largest_left_;
  return r;
}

}  // namespace zona::studies
