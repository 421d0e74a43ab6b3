#include "studies/references/sheared_membrane.h"

#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

/// Principal stresses turned to axes in which the first makes the angle with cos 2a, sin 2a.
ShearedState turned(const PrincipalStresses& s, double cos2, double sin2) {
  const double mean = 0.5 * (s.first + s.second), radius = 0.5 * (s.first - s.second);
  return {mean + radius * cos2, mean - radius * cos2, radius * sin2, s.state};
}

}  // namespace

ShearedState linearly_sheared(const MembraneLaw& law, double prestrain, double gamma) {
  check(law);
  const double half = 0.5 * std::abs(gamma);
  return turned(principal_stresses(law, prestrain + half, prestrain - half), 0, gamma < 0 ? -1 : 1);
}

double wrinkling_shear(const MembraneLaw& law, double prestrain) {
  check(law);
  return 2 * prestrain * (1 + law.poisson_ratio) / (1 - law.poisson_ratio);
}

ShearedState finitely_sheared(const MembraneLaw& law, double prestretch, double gamma) {
  check(law);
  require_positive(prestretch, "prestretch");
  // F F^T / prestretch^2 = [1 + gamma^2, gamma; gamma, 1], eigenvalues m and 1/m.
  const double mean = 1 + 0.5 * gamma * gamma;
  const double radius = std::hypot(0.5 * gamma * gamma, gamma);
  const double larger = std::sqrt(mean + radius);
  const double cos2 = radius > 0 ? 0.5 * gamma * gamma / radius : 1;
  const double sin2 = radius > 0 ? gamma / radius : 0;
  const double e1 = strain_of(law.strain, prestretch * larger).value;
  const double e2 = strain_of(law.strain, prestretch / larger).value;
  return turned(principal_stresses(law, e1, e2), cos2, sin2);
}

}  // namespace zona::studies::references
