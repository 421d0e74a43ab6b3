#include "studies/references/inflated_sphere.h"

#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

double sphere_pressure(const MembraneLaw& law, double radius, double stretch) {
  check(law);
  require_positive(radius, "radius");
  require(stretch >= 1,
          "an inflated sphere has a stretch of 1 or more, not " + std::to_string(stretch));
  return 2 * membrane_tensions(law, stretch, stretch).first / (radius * stretch * stretch);
}

double sphere_limit_stretch(const MembraneLaw& law) {
  check(law);
  // d/d lambda of e/lambda^n = 0: lambda = n/(n - 1) for Biot, exp(1/n) for logarithmic strain.
  const double n = law.stress == StressMeasure::kirchhoff ? 3 : 2;
  return law.strain == StrainMeasure::biot ? n / (n - 1) : std::exp(1 / n);
}

double sphere_stretch(const MembraneLaw& law, double radius, double pressure) {
  double low = 1, high = sphere_limit_stretch(law);
  const double greatest = sphere_pressure(law, radius, high);
  require(pressure >= 0 && pressure <= greatest, "the sphere carries pressures in [0, " +
                                                     std::to_string(greatest) + "] Pa, not " +
                                                     std::to_string(pressure));
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (sphere_pressure(law, radius, middle) < pressure ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace zona::studies::references
