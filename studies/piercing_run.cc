#include "studies/piercing_run.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "coupling/tip_trace.h"
#include "mpm/diagnostics.h"
#include "mpm/errors.h"
#include "studies/damage.h"
#include "studies/decohesion_results.h"
#include "studies/history_file.h"
#include "studies/interrupt.h"
#include "studies/piercing_frames.h"
#include "studies/progress.h"

namespace zona::studies {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of this process so far [bytes].
long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

/// Rate of the stepping alone, after the first steps, in which memory is touched for the first
/// time.
class StepTimer {
 public:
  void add(double seconds) {
    if (++steps_ > warm_up) seconds_ += seconds;
  }
  double steps_per_second() const {
    return steps_ > warm_up ? static_cast<double>(steps_ - warm_up) / seconds_ : 0;
  }

 private:
  static constexpr long warm_up = 50;
  long steps_ = 0;
  double seconds_ = 0;
};

const std::vector<Column>& history_columns() {
  static const std::vector<Column> columns{{"time", "s"},
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
                                           {"mass", "kg"},
                                           {"momentum_x", "kg m/s"},
                                           {"momentum_y", "kg m/s"},
                                           {"momentum_z", "kg m/s"},
                                           {"kinetic_energy", "J"},
                                           {"stored_energy", "J"}};
  return columns;
}

/// Steps the solver, samples it and writes; one object per piercing.
class PiercingRun {
 public:
  PiercingRun(const PiercingCase& piercing, const OutputPlan& plan,
              const std::filesystem::path& directory, int threads)
      : case_(piercing),
        plan_(plan),
        solver_(build_piercing(piercing.setup), piercing.step, threads),
        meter_(solver_.body("zona"), piercing_geometry(piercing.setup).tip),
        history_(directory / "history.csv", history_columns()) {
    if (plan.fields) frames_.emplace(directory.string());
    total_steps_ = static_cast<long>(std::floor(piercing.end / piercing.step + 1e-6));
    sample();
    write_frame();
  }

  void run(const std::string& label, Progress& progress) {
    progress.start(label, case_.end);
    const double points = static_cast<double>(solver_.point_count());
    try {
      while (solver_.steps() < total_steps_ && !Interrupt::requested()) {
        step();
        progress.update(solver_.time(), points * static_cast<double>(solver_.steps()),
                        quantities());
      }
    } catch (const mpm::PointError&) {
      sample();
      throw;
    }
    sample();
    write_frame();
    progress.finish();
  }

  nlohmann::json results() const;

 private:
  void step() {
    const auto start = Clock::now();
    solver_.step();
    timer_.add(seconds_since(start));
    const auto* pipette = solver_.body("pipette").prescribed();
    impulse_work_ += pipette->reaction.dot(pipette->next.velocity) * solver_.step_size();
    largest_force_ = std::max(largest_force_, pipette->reaction.norm());
    if (solver_.time() >= next_sample_) sample();
    if (solver_.time() >= next_frame_) write_frame();
  }

  void sample();
  void write_frame();
  std::string quantities() const {
    return fmt::format("{} of {} points failed, strain {:.3f}", damage_.failed_points,
                       solver_.body("zona").points.size(), damage_.largest_strain);
  }

  const PiercingCase& case_;
  OutputPlan plan_;
  mpm::Solver solver_;
  DamageMeter meter_;
  HistoryFile history_;
  std::optional<mpm::FrameWriter> frames_;
  ZonaDamage damage_;
  StepTimer timer_;
  Clock::time_point started_ = Clock::now();
  long total_steps_ = 0;
  double next_sample_ = 0;
  double next_frame_ = 0;
  double last_sample_ = -1;
  double last_frame_ = -1;
  double impulse_work_ = 0;
  double largest_force_ = 0;
  double highest_pressure_ = 0;
  double largest_excursion_ = 0;
};

void PiercingRun::sample() {
  const double t = solver_.time();
  if (t == last_sample_) return;
  last_sample_ = t;
  while (next_sample_ <= t) next_sample_ += plan_.history_interval;
  const auto* pipette = solver_.body("pipette").prescribed();
  const auto state = pipette->state(std::min(t, case_.end));
  damage_ = meter_.measure(solver_.body("zona"));
  const auto pressure = mpm::cell_averaged_pressure(solver_.body("cytoplasm"));
  mpm::BodyTotals sum;
  for (const auto& body : solver_.bodies()) {
    const auto part = mpm::totals(body);
    sum.mass += part.mass;
    sum.momentum += part.momentum;
    sum.kinetic_energy += part.kinetic_energy;
    sum.stored_energy += part.stored_energy;
  }
  highest_pressure_ = std::max(highest_pressure_, pressure.highest);
  largest_excursion_ = std::max(largest_excursion_, state.displacement.norm());
  const auto& d = state.displacement;
  const auto& v = state.velocity;
  const auto& f = pipette->reaction;
  history_.add({t,
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
                sum.mass,
                sum.momentum.x(),
                sum.momentum.y(),
                sum.momentum.z(),
                sum.kinetic_energy,
                sum.stored_energy});
}

void PiercingRun::write_frame() {
  const double t = solver_.time();
  if (!frames_ || t == last_frame_) return;
  last_frame_ = t;
  while (next_frame_ <= t) next_frame_ += plan_.fields_interval;
  frames_->add_frame(t, draw(solver_));
}

nlohmann::json PiercingRun::results() const {
  const auto& zona = *solver_.body("zona").membrane();
  double first_failure = std::numeric_limits<double>::infinity();
  for (double t : zona.integrity.failure_time) first_failure = std::min(first_failure, t);
  nlohmann::json r;
  r["fluid"] = case_.fluid;
  r["fluid_density"] = case_.fluid_density;
  if (case_.tip_history) {
    double amplitude = 0;
    for (double u : case_.tip_history->displacement) amplitude = std::max(amplitude, std::abs(u));
    r["tip_amplitude"] = amplitude;
    r["window_start"] = case_.window_start;
    r["initial_speed"] = case_.setup.pipette.motion(0).velocity.norm();
  }
  r["largest_excursion"] = largest_excursion_;
  r["failed_points"] = zona.failed_points;
  r["failed_area"] = damage_.failed_area;
  r["time_of_first_failure"] =
      std::isfinite(first_failure) ? nlohmann::json(first_failure) : nlohmann::json();
  if (const auto* plastic = std::get_if<mpm::MembraneState<mpm::VonMises>>(&zona.state)) {
    r["decohesion"] = decohesion_results(*plastic);
  }
  r["largest_strain_away"] = meter_.peak_strain_away();
  r["largest_displacement_away"] = meter_.peak_displacement_away();
  r["highest_cytoplasm_pressure"] = highest_pressure_;
  r["largest_pipette_force"] = largest_force_;
  r["pipette_work"] = impulse_work_;
  r["points"] = solver_.point_count();
  r["steps"] = solver_.steps();
  r["simulated_time"] = solver_.time();
  r["time_step"] = case_.step;
  r["critical_time_step"] = case_.critical_step;
  r["wall_seconds"] = seconds_since(started_);
  r["peak_memory_bytes"] = peak_memory();
  r["point_steps_per_second"] =
      timer_.steps_per_second() * static_cast<double>(solver_.point_count());
  return r;
}

}  // namespace

OutputPlan output_plan(const Configuration& study) {
  return {study.quantity("output.history_interval"), study.quantity("output.fields_interval"),
          study.boolean("output.fields")};
}

void run_piercing(const PiercingCase& piercing, const OutputPlan& plan,
                  const std::filesystem::path& directory, const std::string& label,
                  Session& session, nlohmann::json& results) {
  if (piercing.tip_history) {
    coupling::write_tip_trace_csv(*piercing.tip_history, (directory / "tip.csv").string());
  }
  PiercingRun run(piercing, plan, directory, session.threads);
  try {
    run.run(label, session.progress);
  } catch (...) {
    results = run.results();
    throw;
  }
  results = run.results();
}

std::string piercing_cost(const PiercingCase& piercing) {
  const mpm::Model model = build_piercing(piercing.setup);
  double points = 0;
  std::string parts;
  for (const auto& body : model.bodies) {
    points += body.points.size();
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", body.name, body.points.size());
  }
  const double steps = std::floor(piercing.end / piercing.step + 1e-6);
  return fmt::format(
      "{:.0f} points ({}); {:.0f} steps of {:.3g} ns, {:.2f} of the critical step; {:.3g} "
      "point-steps",
      points, parts, steps, piercing.step * 1e9, piercing.step / piercing.critical_step,
      points * steps);
}

}  // namespace zona::studies
