#include "mpm/materials/fluid.h"

#include <fmt/format.h>

#include "mpm/points/errors.h"

namespace zona::mpm {

Fluid::Fluid(const FluidProperties& p, int points)
    : properties(p),
      initial_energy(p.state.internal_energy(p.pressure, p.density)),
      density(points, p.density),
      internal_energy(points, initial_energy) {
  if (!(p.density > 0))
    throw ModelError(fmt::format("a fluid's density must be positive, got {} kg/m^3", p.density));
  if (!(p.shear_viscosity >= 0)) {
    throw ModelError(
        fmt::format("a viscosity must not be negative, got {} Pa s", p.shear_viscosity));
  }
  if (!(p.state.grueneisen > 0) || !(p.pressure + p.state.p_infinity > 0)) {
    throw ModelError(
        fmt::format("a fluid needs positive Gamma and P + P_inf for a sound speed, "
                    "got {} and {} Pa",
                    p.state.grueneisen, p.pressure + p.state.p_infinity));
  }
  for (int c = 0; c < 6; ++c) stress[c].assign(points, c < 3 ? -p.pressure : 0.0);
}

}  // namespace zona::mpm
