#include "mpm/materials/solid.h"

#include <fmt/format.h>

#include "mpm/points/errors.h"

namespace zona::mpm {

void check(const ElasticProperties& p) {
  if (!(p.density > 0) || !(p.youngs_modulus > 0)) {
    throw ModelError(fmt::format(
        "an elastic solid needs positive density and Young's modulus, got {} kg/m^3, {} Pa",
        p.density, p.youngs_modulus));
  }
  if (!(p.poisson_ratio > -1 && p.poisson_ratio < 0.5)) {
    throw ModelError(fmt::format("a solid's Poisson ratio must lie between -1 and 0.5, got {}",
                                 p.poisson_ratio));
  }
}

}  // namespace zona::mpm
