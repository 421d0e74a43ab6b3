#include "mpm/step/critical_step.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace zona::mpm {

CriticalStep critical_step(const BackgroundGrid& grid, const std::vector<Body>& bodies,
                           bool implicit_pressure) {
  CriticalStep critical{std::numeric_limits<double>::infinity(), "", "nothing limits the step"};
  const bool quadratic = grid.interpolation() == Interpolation::quadratic;
  const double h = grid.cell_size().minCoeff() * (quadratic ? std::sqrt(2.0 / 3) : 1);
  const std::string across = quadratic ? "0.816 of a cell (quadratic functions), " : "a cell of ";
  const auto consider = [&](double seconds, const Body& body, const std::string& reason) {
    if (seconds < critical.seconds) critical = {seconds, body.name, reason};
  };
  for (const auto& body : bodies) {
    const bool waits_for_sound =
        !(implicit_pressure && std::holds_alternative<Fluid>(body.material));
    const double c = waits_for_sound ? body.wave_speed() : 0;
    if (c > 0)
      consider(h / c, body, fmt::format("waves at {:.4g} m/s cross {}{:.4g} m", c, across, h));
    if (const auto* fluid = std::get_if<Fluid>(&body.material)) {
      const double mu = fluid->properties.shear_viscosity;
      if (mu > 0) {
        consider(fluid->properties.density * h * h / (8 * mu), body,
                 fmt::format("a viscosity of {:.4g} Pa s in {}{:.4g} m", mu, across, h));
      }
    }
  }
  return critical;
}

}  // namespace zona::mpm
