#include "studies/kinds/scene/run.h"

#include <fmt/format.h>

#include <cmath>

#include "mpm/results/diagnostics.h"
#include "studies/measures/measures.h"
#include "studies/run/history_file.h"
#include "studies/run/run_directory.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;

/// Force that something exerts on the points around it, and its work since the start.
struct Effort {
  Vector3d force = Vector3d::Zero();  ///< [N], last step
  double work = 0;                    ///< [J]

  void add(const Vector3d& reaction, double power, double dt) {
    force = reaction;
    work += power * dt;
  }
  void visit_state(const std::string& name, mpm::StateVisitor& visitor) {
    visitor.visit(name + "/force", force);
    visitor.visit(name + "/work", work);
  }
};

void add_vector(std::vector<Column>& columns, const std::string& prefix, const std::string& unit) {
  for (const char* axis : {"x", "y", "z"}) columns.push_back({prefix + axis, unit});
}

void add_effort(std::vector<Column>& columns, const std::string& prefix) {
  add_vector(columns, prefix + "force_", "N");
  columns.push_back({prefix + "work", "J"});
}

void add_effort(std::vector<double>& row, const Effort& effort) {
  row.insert(row.end(), {effort.force.x(), effort.force.y(), effort.force.z(), effort.work});
}

/// A scene while it runs.
class SceneRun {
 public:
  SceneRun(SceneCase& scene, const Session& session)
      : study_(scene.study),
        step_(scene.step),
        gravity_(scene.model.gravity),
        solver_(std::move(scene.model), scene.step.seconds, session.threads),
        checkpoints_(session.directory.path(), checkpoint_plan(study_, session.resume)),
        measures_(study_, solver_, Vector3d::Zero(), scene.end, session.directory.path(),
                  checkpoints_.is_resumed()),
        rigid_(solver_.bodies().size()),
        held_(solver_.held().size()),
        history_(session.directory.file("history.csv"), columns(), checkpoints_.is_resumed()),
        march_(solver_, scene.end, output_plan(study_, scene.end), session.directory.path(),
               checkpoints_, session.directory.log(),
               {[this] { follow(); }, [this] { sample(); }, [this] { return status(); },
                [this](mpm::StateVisitor& visitor) { visit_state(visitor); }}) {
    if (!checkpoints_.is_resumed()) measures_.write_due();
    march_.tell_start(session.progress);
  }

  void run(Progress& progress) { march_.run(progress); }
  nlohmann::json results() const;

 private:
  std::vector<Column> columns() const;
  void follow();
  void visit_state(mpm::StateVisitor& visitor);
  void sample();
  std::string status() const { return fmt::format("kinetic energy {:.4g} J", kinetic_energy_); }
  nlohmann::json body_results(std::size_t b) const;

  const Configuration& study_;
  TimeStep step_;
  Vector3d gravity_;
  mpm::Solver solver_;
  Checkpoints checkpoints_;
  Measures measures_;
  std::vector<Effort> rigid_;  ///< per body; of those that move as prescribed
  std::vector<Effort> held_;
  HistoryFile history_;
  double kinetic_energy_ = 0;
  SolverMarch march_;  ///< last, because it samples at once
};

std::vector<Column> SceneRun::columns() const {
  std::vector<Column> columns{{"time", "s"}, {"mass", "kg"}};
  add_vector(columns, "momentum_", "kg m/s");
  for (const char* energy : {"kinetic_energy", "stored_energy", "potential_energy"}) {
    columns.push_back({energy, "J"});
  }
  for (const mpm::Body& body : solver_.bodies()) {
    const std::string prefix = "body." + body.name + ".";
    columns.push_back({prefix + "kinetic_energy", "J"});
    columns.push_back({prefix + "stored_energy", "J"});
    if (body.membrane() != nullptr) columns.push_back({prefix + "failed_points", ""});
    if (body.prescribed() == nullptr) continue;
    add_vector(columns, prefix + "displacement_", "m");
    add_effort(columns, prefix);
  }
  for (const Table& hold : study_.items("hold")) {
    add_effort(columns, "hold." + hold.name() + ".");
  }
  measures_.add_columns(columns);
  return columns;
}

void SceneRun::follow() {
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
  measures_.write_due();
}

void SceneRun::visit_state(mpm::StateVisitor& visitor) {
  history_.visit_state(visitor);
  measures_.visit_state(visitor);
  for (std::size_t b = 0; b < rigid_.size(); ++b) {
    rigid_[b].visit_state(fmt::format("rigid/{}", b), visitor);
  }
  for (std::size_t h = 0; h < held_.size(); ++h) {
    held_[h].visit_state(fmt::format("holds/{}", h), visitor);
  }
  visitor.visit("kinetic_energy", kinetic_energy_);
}

void SceneRun::sample() {
  mpm::BodyTotals sum;
  double potential_energy = 0;
  std::vector<double> parts;
  for (std::size_t b = 0; b < solver_.bodies().size(); ++b) {
    const mpm::Body& body = solver_.bodies()[b];
    const mpm::BodyTotals part = mpm::totals(body);
    sum += part;
    potential_energy -= gravity_.dot(mpm::first_moment(body));
    parts.insert(parts.end(), {part.kinetic_energy, part.stored_energy});
    if (body.membrane() != nullptr) parts.push_back(body.membrane()->failed_points);
    if (body.prescribed() == nullptr) continue;
    const Vector3d u = body.prescribed()->state(solver_.time()).displacement;
    parts.insert(parts.end(), {u.x(), u.y(), u.z()});
    add_effort(parts, rigid_[b]);
  }
  kinetic_energy_ = sum.kinetic_energy;
  std::vector<double> row{solver_.time(),    sum.mass,         sum.momentum.x(),
                          sum.momentum.y(),  sum.momentum.z(), sum.kinetic_energy,
                          sum.stored_energy, potential_energy};
  row.insert(row.end(), parts.begin(), parts.end());
  for (const Effort& effort : held_) add_effort(row, effort);
  measures_.add_values(row);
  history_.add(row);
}

nlohmann::json SceneRun::body_results(std::size_t b) const {
  const mpm::Body& body = solver_.bodies()[b];
  const mpm::BodyTotals totals = mpm::totals(body);
  nlohmann::json r{{"points", body.points.size()},
                   {"mass", totals.mass},
                   {"kinetic_energy", totals.kinetic_energy},
                   {"stored_energy", totals.stored_energy}};
  if (const auto* membrane = body.membrane()) r["failed_points"] = membrane->failed_points;
  if (body.prescribed() != nullptr) {
    const Vector3d& force = rigid_[b].force;
    r["force"] = {force.x(), force.y(), force.z()};
    r["work"] = rigid_[b].work;
  }
  return r;
}

nlohmann::json SceneRun::results() const {
  nlohmann::json r;
  for (std::size_t b = 0; b < solver_.bodies().size(); ++b) {
    r["bodies"][solver_.bodies()[b].name] = body_results(b);
  }
  const std::vector<Table> holds = study_.items("hold");
  for (std::size_t h = 0; h < held_.size(); ++h) {
    const Vector3d& force = held_[h].force;
    r["holds"][holds[h].name()] = {{"force", {force.x(), force.y(), force.z()}},
                                   {"work", held_[h].work}};
  }
  measures_.add_results(r);
  r["time_step"] = step_.seconds;
  r["critical_time_step"] = step_.critical;
  march_.add_cost(r);
  return r;
}

}  // namespace

void run_scene(SceneCase& scene, Session& session) {
  const double end = scene.end;
  SceneRun run(scene, session);
  session.progress.start("scene", end);
  try {
    run.run(session.progress);
    session.progress.finish();
  } catch (...) {
    session.results = run.results();
    throw;
  }
  session.results = run.results();
}

}  // namespace zona::studies
