#include "mpm/critical_step.h"

#include <fmt/format.h>

#include <limits>

namespace zona::mpm {

CriticalStep critical_step(const BackgroundGrid& grid, const std::vector<Body>& bodies) {
  CriticalStep critical{std::numeric_limits<double>::infinity(), "", "nothing limits the step"};
  const double h = grid.cell_size().minCoeff();
  const auto consider = [&](double seconds, const Body& body, const std::string& reason) {
    if (seconds < critical.seconds) critical = {seconds, body.name, reason};
  };
  for (const auto& body : bodies) {
    const double c = body.wave_speed();
    if (c > 0)
      consider(h / c, body, fmt::format("waves at {:.4g} m/s cross a cell of {:.4g} m", c, h));
    if (const auto* fluid = std::get_if<Fluid>(&body.material)) {
      const double mu = fluid->properties.shear_viscosity;
      if (mu > 0) {
        consider(fluid->properties.density * h * h / (8 * mu), body,
                 fmt::format("a viscosity of {:.4g} Pa s in a cell of {:.4g} m", mu, h));
      }
    }
  }
  return critical;
}

}  // namespace zona::mpm
