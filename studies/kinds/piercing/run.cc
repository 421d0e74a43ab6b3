#include "studies/kinds/piercing/run.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "coupling/tip_trace.h"
#include "mpm/files/atomic_file.h"
#include "mpm/results/diagnostics.h"
#include "studies/kinds/piercing/damage.h"
#include "studies/kinds/piercing/decohesion_results.h"
#include "studies/kinds/piercing/failure_pattern.h"
#include "studies/measures/measures.h"
#include "studies/run/history_file.h"
#include "studies/simulation/checkpoints.h"

namespace zona::studies {

namespace {

std::vector<Column> history_columns(const Measures& measures) {
  std::vector<Column> columns{{"time", "s"},
                              {"pipette_x", "m"},
                              {"pipette_y", "m"},
                              {"pipette_z", "m"},
                              {"pipette_vx", "m/s"},
                              {"pipette_vy", "m/s"},
                              {"pipette_vz", "m/s"},
                              {"force_x", "N"},
                              {"force_y", "N"},
                              {"force_z", "N"},
                              {"pipette_work", "J"},
                              {"failed_points", ""},
                              {"failed_area", "m^2"},
                              {"largest_strain", ""},
                              {"strain_away", ""},
                              {"largest_displacement", "m"},
                              {"cytoplasm_pressure_low", "Pa"},
                              {"cytoplasm_pressure_high", "Pa"},
                              {"cytoplasm_shear_rate", "1/s"},
                              {"indentation", "m"},
                              {"mass", "kg"},
                              {"momentum_x", "kg m/s"},
                              {"momentum_y", "kg m/s"},
                              {"momentum_z", "kg m/s"},
                              {"kinetic_energy", "J"},
                              {"stored_energy", "J"},
                              {"plate_force_x", "N"},
                              {"plate_force_y", "N"},
                              {"plate_force_z", "N"}};
  measures.add_columns(columns);
  return columns;
}

std::string content(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A piercing while it runs.
class PiercingRun {
 public:
  PiercingRun(const PiercingCase& piercing, const PiercingWork& work)
      : case_(piercing),
        log_(work.log),
        solver_(build_piercing(piercing.setup), piercing.step, work.threads),
        meter_(solver_.body("zona"), piercing_geometry(piercing.setup).tip),
        checkpoints_(work.directory, work.checkpoints),
        measures_(work.study, solver_, piercing_geometry(piercing.setup).egg_center, piercing.end,
                  work.directory, checkpoints_.is_resumed()),
        history_(work.directory / "history.csv", history_columns(measures_),
                 checkpoints_.is_resumed()),
        march_(solver_, piercing.end, work.plan, work.directory, checkpoints_, work.log,
               {[this] { follow(); }, [this] { sample(); }, [this] { return status(); },
                [this](mpm::StateVisitor& visitor) { visit_state(visitor); }}) {
    if (!checkpoints_.is_resumed()) measures_.write_due();
    march_.tell_start(work.progress);
  }

  void run(Progress& progress, int part) { march_.run(progress, part); }
  nlohmann::json results() const;

 private:
  void follow() {
    measures_.write_due();
    const auto* pipette = solver_.body("pipette").prescribed();
    impulse_work_ += pipette->reaction.dot(pipette->next.velocity) * solver_.step_size();
    largest_force_ = std::max(largest_force_, pipette->reaction.norm());
    if (damage_.failed_points > 0)
      path_after_failure_ += pipette->next.velocity.norm() * solver_.step_size();
  }
  /// On its surroundings in the last step; zero where there is no plate [N].
  Eigen::Vector3d plate_force() const {
    for (const mpm::Body& body : solver_.bodies()) {
      if (body.name == "plate") return body.prescribed()->reaction;
    }
    return Eigen::Vector3d::Zero();
  }
  void sample();
  void visit_state(mpm::StateVisitor& visitor);
  std::string status() const {
    return fmt::format("{} of {} points failed, strain {:.3f}", damage_.failed_points,
                       solver_.body("zona").points.size(), damage_.largest_strain);
  }

  const PiercingCase& case_;
  spdlog::logger& log_;
  mpm::Solver solver_;
  DamageMeter meter_;
  Checkpoints checkpoints_;
  Measures measures_;
  HistoryFile history_;
  ZonaDamage damage_;
  double impulse_work_ = 0;
  double largest_force_ = 0;
  double highest_pressure_ = 0;
  double highest_shear_rate_ = 0;
  double deepest_indentation_ = 0;
  double path_after_failure_ = 0;  ///< of the tip, counted from the sample that saw a failure [m]
  double largest_excursion_ = 0;
  SolverMarch march_;  ///< last, because it samples at once
};

void PiercingRun::sample() {
  const double t = solver_.time();
  const auto* pipette = solver_.body("pipette").prescribed();
  const auto state = pipette->state(std::min(t, case_.end));
  const bool was_whole = damage_.failed_points == 0;
  damage_ = meter_.measure(solver_.body("zona"));
  if (was_whole && damage_.failed_points > 0) {
    log_.info("the zona begins to fail before {:.4g} us", t * 1e6);
  }
  const auto pressure = mpm::cell_averaged_pressure(solver_.body("cytoplasm"));
  const double shear_rate = mpm::cell_averaged_shear_rate(solver_.body("cytoplasm"));
  const mpm::BodyTotals sum = totals(solver_.bodies());
  highest_pressure_ = std::max(highest_pressure_, pressure.highest);
  highest_shear_rate_ = std::max(highest_shear_rate_, shear_rate);
  deepest_indentation_ = std::max(deepest_indentation_, damage_.indentation);
  largest_excursion_ = std::max(largest_excursion_, state.displacement.norm());
  const auto& d = state.displacement;
  const auto& v = state.velocity;
  const auto& f = pipette->reaction;
  const Eigen::Vector3d plate = plate_force();
  std::vector<double> row{t,
                          d.x(),
                          d.y(),
                          d.z(),
                          v.x(),
                          v.y(),
                          v.z(),
                          f.x(),
                          f.y(),
                          f.z(),
                          impulse_work_,
                          static_cast<double>(damage_.failed_points),
                          damage_.failed_area,
                          damage_.largest_strain,
                          damage_.strain_away,
                          damage_.largest_displacement,
                          pressure.lowest,
                          pressure.highest,
                          shear_rate,
                          damage_.indentation,
                          sum.mass,
                          sum.momentum.x(),
                          sum.momentum.y(),
                          sum.momentum.z(),
                          sum.kinetic_energy,
                          sum.stored_energy,
                          plate.x(),
                          plate.y(),
                          plate.z()};
  measures_.add_values(row);
  history_.add(row);
}

void PiercingRun::visit_state(mpm::StateVisitor& visitor) {
  history_.visit_state(visitor);
  meter_.visit_state(visitor);
  damage_.visit_state(visitor);
  measures_.visit_state(visitor);
  visitor.visit("pipette/impulse_work", impulse_work_);
  visitor.visit("pipette/largest_force", largest_force_);
  visitor.visit("pipette/largest_excursion", largest_excursion_);
  visitor.visit("cytoplasm/highest_pressure", highest_pressure_);
  visitor.visit("cytoplasm/highest_shear_rate", highest_shear_rate_);
  visitor.visit("zona/deepest_indentation", deepest_indentation_);
  visitor.visit("pipette/path_after_failure", path_after_failure_);
}

nlohmann::json PiercingRun::results() const {
  const auto& zona = *solver_.body("zona").membrane();
  double first_failure = std::numeric_limits<double>::infinity();
  for (double t : zona.integrity.failure_time) first_failure = std::min(first_failure, t);
  nlohmann::json r;
  r["fluid"] = case_.fluid.name;
  r["fluid_density"] = case_.fluid.density;
  if (case_.tip_history) {
    double amplitude = 0;
    for (double u : case_.tip_history->displacement) amplitude = std::max(amplitude, std::abs(u));
    r["tip_amplitude"] = amplitude;
    r["window_start"] = case_.window_start;
    if (case_.axial_tip_history) {
      const std::vector<double>& axial = case_.axial_tip_history->displacement;
      r["axial_tip_amplitude"] = std::abs(axial[beam::index_of_peak(axial)]);
    }
    if (!case_.bath_warnings.empty()) r["warnings"] = case_.bath_warnings;
    r["initial_speed"] = case_.setup.pipette.motion(0).velocity.norm();
  }
  r["largest_excursion"] = largest_excursion_;
  r["failed_points"] = zona.failed_points;
  r["failed_area"] = damage_.failed_area;
  // Of a round hole of this area, in diameters of the pipette.
  r["hole_diameter"] = std::sqrt(4 * damage_.failed_area / M_PI);
  r["hole_over_pipette"] =
      std::sqrt(4 * damage_.failed_area / M_PI) / case_.setup.pipette.outer_diameter;
  r["failure_pattern"] =
      to_json(failure_pattern(zona, meter_.reference(), piercing_geometry(case_.setup).tip));
  r["time_of_first_failure"] =
      std::isfinite(first_failure) ? nlohmann::json(first_failure) : nlohmann::json();
  if (const auto* plastic = std::get_if<mpm::MembraneState<mpm::VonMises>>(&zona.state)) {
    r["decohesion"] = decohesion_results(*plastic);
  }
  r["largest_strain_away"] = meter_.peak_strain_away();
  r["largest_displacement_away"] = meter_.peak_displacement_away();
  r["deepest_indentation"] = deepest_indentation_;
  r["highest_cytoplasm_pressure"] = highest_pressure_;
  r["highest_cytoplasm_shear_rate"] = highest_shear_rate_;
  r["path_after_failure"] = path_after_failure_;
  r["largest_pipette_force"] = largest_force_;
  r["pipette_work"] = impulse_work_;
  r["time_step"] = case_.step;
  r["critical_time_step"] = case_.critical_step;
  measures_.add_results(r);
  march_.add_cost(r);
  return r;
}

/// What is resumed must have the history that it had.
void write_tip_history(const beam::TipHistory& history, const char* name,
                       const PiercingWork& work) {
  const std::string file = (work.directory / name).string();
  const std::string old = work.checkpoints.resume ? content(file) : "";
  coupling::write_tip_trace_csv(history, file);
  if (old.empty() || old == content(file)) return;
  mpm::replace_file(file, old);
  throw mpm::CheckpointError("the tip now moves in another way than when the run was started (" +
                             file + "): a trace has changed; run the study anew");
}

}  // namespace

void run_piercing(const PiercingCase& piercing, const PiercingWork& work, nlohmann::json& results) {
  if (piercing.tip_history) write_tip_history(*piercing.tip_history, "tip.csv", work);
  if (piercing.axial_tip_history)
    write_tip_history(*piercing.axial_tip_history, "tip_axial.csv", work);
  PiercingRun run(piercing, work);
  try {
    run.run(work.progress, work.part);
  } catch (...) {
    results = run.results();
    throw;
  }
  results = run.results();
}

StudyCost piercing_cost(const PiercingCase& piercing) {
  const mpm::Model model = build_piercing(piercing.setup);
  double points = 0;
  std::string parts;
  for (const auto& body : model.bodies) {
    points += body.points.size();
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", body.name, body.points.size());
  }
  const auto steps = static_cast<double>(step_count(piercing.end, piercing.step));
  return {fmt::format(
              "{:.0f} points ({}); {:.0f} steps of {:.3g} ns, {:.2f} of the critical step; {:.3g} "
              "point-steps",
              points, parts, steps, piercing.step * 1e9, piercing.step / piercing.critical_step,
              points * steps),
          points * steps};
}

}  // namespace zona::studies
