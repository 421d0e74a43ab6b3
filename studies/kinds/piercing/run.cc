#include "studies/kinds/piercing/run.h"

#include <fmt/format.h>

#include "coupling/tip_trace.h"
#include "mpm/files/atomic_file.h"
#include "mpm/files/read_file.h"
#include "studies/kinds/piercing/observer.h"
#include "studies/parameters/time_step.h"

namespace zona::studies {

namespace {

/// Writes a tip history as CSV. Throws CheckpointError, and keeps the file, if a resumed run was
/// started with another history.
void write_tip_history(const beam::TipHistory& history, const char* name,
                       const SimulationContext& context) {
  const std::string file = (context.directory / name).string();
  const std::string old = context.checkpoints.resume ? mpm::read_file(file).value_or("") : "";
  coupling::write_tip_trace_csv(history, file);
  if (old.empty() || old == mpm::read_file(file)) return;
  mpm::replace_file(file, old);
  throw mpm::CheckpointError("the motion of the tip has changed since the run was started (" +
                             file + "): a trace has changed; run the study anew");
}

}  // namespace

void run_piercing(const PiercingCase& piercing, const SimulationContext& context,
                  nlohmann::json& results) {
  if (piercing.tip_history) write_tip_history(*piercing.tip_history, "tip.csv", context);
  if (piercing.axial_tip_history)
    write_tip_history(*piercing.axial_tip_history, "tip_axial.csv", context);
  Simulation simulation({build_piercing(piercing.setup), piercing.step, piercing.end,
                         piercing_geometry(piercing.setup).egg_center},
                        context);
  PiercingObserver observer(piercing, simulation.solver(), context.log);
  simulation.start(observer);
  try {
    simulation.run();
  } catch (...) {
    results = simulation.results();
    throw;
  }
  results = simulation.results();
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
  return {
      fmt::format(
          "{:.0f} points ({}); {:.0f} steps of {:.3g} ns, {:.2f} of the critical step, bound by "
          "{}; {:.3g} point-steps",
          points, parts, steps, piercing.step * 1e9, piercing.step / piercing.critical_step,
          piercing.step_bound_by, points * steps),
      points * steps};
}

}  // namespace zona::studies
