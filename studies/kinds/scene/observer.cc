#include "studies/kinds/scene/observer.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "studies/kinds/scene/hold_table.h"

namespace zona::studies {

using Eigen::Vector3d;

void SceneObserver::Effort::add(const Vector3d& reaction, double power, double dt) {
  force = reaction;
  work += power * dt;
}

void SceneObserver::Effort::visit_state(const std::string& name, mpm::StateVisitor& visitor) {
  visitor.visit(name + "/force", force);
  visitor.visit(name + "/work", work);
}

void SceneObserver::Effort::add_columns(std::vector<ValueColumn<>>& columns,
                                        const std::string& prefix) const {
  add_vector(columns, prefix + "force_", "N", [this] { return force; });
  columns.push_back({prefix + "work", "J", [this] { return work; }});
}

SceneObserver::SceneObserver(const Configuration& study, const TimeStep& step,
                             const mpm::Solver& solver, const Vector3d& gravity)
    : study_(study),
      step_(step),
      solver_(solver),
      gravity_(gravity),
      totals_(solver.bodies().size()),
      rigid_(solver.bodies().size()),
      held_(solver.held().size()) {}

std::vector<ValueColumn<>> SceneObserver::columns() {
  std::vector<ValueColumn<>> columns{{"time", "s", [this] { return solver_.time(); }},
                                     {"mass", "kg", [this] { return sum_.mass; }}};
  add_vector(columns, "momentum_", "kg m/s", [this] { return sum_.momentum; });
  columns.push_back({"kinetic_energy", "J", [this] { return sum_.kinetic_energy; }});
  columns.push_back({"stored_energy", "J", [this] { return sum_.stored_energy; }});
  columns.push_back({"potential_energy", "J", [this] { return potential_energy_; }});
  for (std::size_t b = 0; b < totals_.size(); ++b) add_body_columns(columns, b);
  const std::vector<Table> holds = study_.items<Hold>();
  for (std::size_t h = 0; h < holds.size(); ++h)
    held_[h].add_columns(columns, "hold." + holds[h].name() + ".");
  return columns;
}

void SceneObserver::add_body_columns(std::vector<ValueColumn<>>& columns, std::size_t b) const {
  const mpm::Body& body = solver_.bodies()[b];
  const std::string prefix = "body." + body.name + ".";
  columns.push_back(
      {prefix + "kinetic_energy", "J", [this, b] { return totals_[b].kinetic_energy; }});
  columns.push_back(
      {prefix + "stored_energy", "J", [this, b] { return totals_[b].stored_energy; }});
  if (body.membrane() != nullptr) {
    columns.push_back({prefix + "failed_points", "",
                       [this, b] { return solver_.bodies()[b].membrane()->failed_points; }});
  }
  if (body.prescribed() == nullptr) return;
  add_vector(columns, prefix + "displacement_", "m", [this, b] {
    return solver_.bodies()[b].prescribed()->state(solver_.time()).displacement;
  });
  rigid_[b].add_columns(columns, prefix);
}

void SceneObserver::after_step() {
  const double dt = solver_.step_size();
  for (std::size_t b = 0; b < rigid_.size(); ++b) {
    const auto* rigid = solver_.bodies()[b].prescribed();
    if (rigid == nullptr) continue;
    rigid_[b].add(rigid->reaction, rigid->reaction.dot(rigid->next.velocity), dt);
  }
  for (std::size_t h = 0; h < held_.size(); ++h) {
    const mpm::HeldNodes& held = solver_.held()[h];
    held_[h].add(held.reaction, held.power, dt);
  }
}

void SceneObserver::measure() {
  sum_ = {};
  potential_energy_ = 0;
  for (std::size_t b = 0; b < totals_.size(); ++b) {
    const mpm::Body& body = solver_.bodies()[b];
    totals_[b] = mpm::totals(body);
    sum_ += totals_[b];
    potential_energy_ -= gravity_.dot(mpm::first_moment(body));
  }
  kinetic_energy_ = sum_.kinetic_energy;
}

void SceneObserver::visit_state(mpm::StateVisitor& visitor) {
  for (std::size_t b = 0; b < rigid_.size(); ++b) {
    rigid_[b].visit_state(fmt::format("rigid/{}", b), visitor);
  }
  for (std::size_t h = 0; h < held_.size(); ++h) {
    held_[h].visit_state(fmt::format("holds/{}", h), visitor);
  }
  visitor.visit("kinetic_energy", kinetic_energy_);
}

std::string SceneObserver::status() const {
  return fmt::format("kinetic energy {:.4g} J", kinetic_energy_);
}

nlohmann::json SceneObserver::body_results(std::size_t b) const {
  const mpm::Body& body = solver_.bodies()[b];
  const mpm::BodyTotals totals = mpm::totals(body);
  nlohmann::json results{{"points", body.points.size()},
                         {"mass", totals.mass},
                         {"kinetic_energy", totals.kinetic_energy},
                         {"stored_energy", totals.stored_energy}};
  if (const auto* membrane = body.membrane()) results["failed_points"] = membrane->failed_points;
  if (body.prescribed() != nullptr) {
    const Vector3d& force = rigid_[b].force;
    results["force"] = {force.x(), force.y(), force.z()};
    results["work"] = rigid_[b].work;
  }
  return results;
}

void SceneObserver::add_results(nlohmann::json& results) const {
  for (std::size_t b = 0; b < totals_.size(); ++b) {
    results["bodies"][solver_.bodies()[b].name] = body_results(b);
  }
  const std::vector<Table> holds = study_.items<Hold>();
  for (std::size_t h = 0; h < held_.size(); ++h) {
    const Vector3d& force = held_[h].force;
    results["holds"][holds[h].name()] = {{"force", {force.x(), force.y(), force.z()}},
                                         {"work", held_[h].work}};
  }
  results["time_step"] = step_.seconds;
  if (const mpm::ImplicitPressure* pressure = solver_.implicit_pressure())
    results["pressure_iterations"] = pressure->mean_iterations();
  results["critical_time_step"] =
      std::isfinite(step_.critical) ? nlohmann::json(step_.critical) : nlohmann::json();
}

}  // namespace zona::studies
