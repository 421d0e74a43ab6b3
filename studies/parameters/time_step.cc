#include "studies/parameters/time_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/parameters/step_table.h"

namespace zona::studies {

namespace {

/// Greatest speed that is prescribed until `end` [s], or that points have at the start or reach by
/// falling through the grid [m/s].
double fastest_motion(const mpm::Model& model, double end) {
  constexpr int instants = 2000;
  double fastest = 0;
  const auto consider = [&](const Eigen::Vector3d& v) { fastest = std::max(fastest, v.norm()); };
  for (const mpm::Body& body : model.bodies) {
    if (const mpm::Prescribed* rigid = body.prescribed()) {
      for (int n = 0; n <= instants; ++n) consider(rigid->state(end * n / instants).velocity);
    } else {
      for (int p = 0; p < body.points.size(); ++p) consider(body.points.velocity_of(p));
    }
  }
  for (const mpm::HeldNodes& held : model.held) {
    for (const int node : mpm::nodes_in(model.grid, held.region)) {
      for (int n = 0; n <= 100; ++n)
        consider(mpm::velocity_of(held, end * n / 100, model.grid, node));
    }
  }
  const Eigen::Vector3d extent = model.grid.upper_corner() - model.grid.origin();
  const double fall = std::sqrt(2 * model.gravity.cwiseAbs().dot(extent));
  return std::max(fastest, std::min(fall, model.gravity.norm() * end));
}

}  // namespace

TimeStep time_step(const Configuration& study, const mpm::Model& model, double end) {
  const auto refuse = [&](const std::string& message) {
    return InputError(study.problem(&StepChoice::step, message));
  };
  const bool implicit = model.numerics.implicit_pressure;
  if (implicit && model.grid.interpolation() == mpm::Interpolation::quadratic) {
    throw InputError(study.problem(&mpm::Numerics::implicit_pressure,
                                   "implicit pressure needs numerics.interpolation = \"linear\""));
  }
  if (implicit && model.numerics.damping > 0) {
    throw InputError(study.problem(&mpm::Numerics::implicit_pressure,
                                   "implicit pressure cannot be combined with numerics.damping, "
                                   "which acts on explicit forces"));
  }
  const auto critical = mpm::critical_step(model.grid, model.bodies, implicit);
  const auto choice = study.read<StepChoice>();
  // Time in which the fastest motion travels a cell.
  const double speed = implicit ? fastest_motion(model, end) : 0;
  const double crossing = speed > 0 ? model.grid.cell_size().minCoeff() / speed
                                    : std::numeric_limits<double>::infinity();
  if (!choice.step) {
    const bool by_motion = choice.travel * crossing < choice.courant * critical.seconds;
    const double longest = by_motion ? choice.travel * crossing : choice.courant * critical.seconds;
    if (!std::isfinite(longest)) {
      throw refuse(
          "nothing limits the step, because no body has waves; give one, e.g. step = \"1 us\"");
    }
    return {end / std::ceil(end / longest), critical.seconds,
            by_motion ? fmt::format("motion at {:.3g} m/s", speed)
                      : fmt::format("'{}': {}", critical.body, critical.reason)};
  }
  const double step = *choice.step;
  if (step > critical.seconds) {
    throw refuse(
        fmt::format("{:.4g} ns is above the critical step of {:.4g} ns ({} of '{}'); choose at "
                    "most that, or \"auto\"",
                    step * 1e9, critical.seconds * 1e9, critical.reason, critical.body));
  }
  if (step > 0.5 * crossing) {
    throw refuse(fmt::format(
        "in {:.4g} ns the motion at {:.3g} m/s travels {:.2g} cells; choose at most half a cell, "
        "{:.4g} ns, or \"auto\"",
        step * 1e9, speed, step / crossing, 0.5 * crossing * 1e9));
  }
  return {step, critical.seconds, "the study"};
}

long step_count(double end, double step) {
  return static_cast<long>(std::floor(end / step + 1e-6));
}

}  // namespace zona::studies
