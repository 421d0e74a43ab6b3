#include "studies/references/membrane_strip.h"

#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

void check(const BentStrip& strip) {
  require_positive(strip.youngs_modulus, "Young's modulus");
  require_positive(strip.thickness, "thickness");
  require_positive(strip.height, "height of the strip");
  require_positive(strip.tension, "tension: a strip without it cannot be bent in its plane");
}

/// 2 P/(E h^2 t): the curvature at which wrinkling begins [1/m].
double onset_curvature(const BentStrip& s) {
  return 2 * s.tension / (s.youngs_modulus * s.height * s.height * s.thickness);
}

}  // namespace

StripState free_strip(const MembraneLaw& law, double stretch) {
  require(law.wrinkling != Wrinkling::strain,
          "a free strip whose negative strains are cut has no equilibrium");
  require_positive(stretch, "stretch");
  const double e = strain_of(law.strain, stretch).value;
  return held_strip(law, stretch, stretch_of(law.strain, -law.poisson_ratio * e));
}

StripState held_strip(const MembraneLaw& law, double stretch, double lateral_stretch) {
  check(law);
  require_positive(stretch, "stretch");
  require_positive(lateral_stretch, "lateral stretch");
  const auto s = principal_stresses(law, strain_of(law.strain, stretch).value,
                                    strain_of(law.strain, lateral_stretch).value);
  const auto t = membrane_tensions(law, stretch, lateral_stretch);
  return {s.first, s.second, t.first, lateral_stretch, s.state};
}

BentStripState bent_strip(const BentStrip& strip, double moment) {
  check(strip);
  const double m = moment / (strip.tension * strip.height);
  require(m >= 0 && m < 0.5,
          "a strip under tension P and height h carries moments in [0, P h/2), not " +
              std::to_string(m) + " P h");
  const double mean = strip.tension / (strip.thickness * strip.height);
  if (m <= 1.0 / 6) return {onset_curvature(strip) * 6 * m, 0, mean * (1 + 6 * m)};
  const double taut = 1.5 - 3 * m;  // share of the height
  return {onset_curvature(strip) / (taut * taut), strip.height * (1 - taut), 2 * mean / taut};
}

double bent_strip_moment(const BentStrip& strip, double curvature) {
  check(strip);
  require(curvature >= 0, "the curvature is not negative");
  const double k = curvature / onset_curvature(strip);
  const double m = k <= 1 ? k / 6 : 0.5 - 1 / (3 * std::sqrt(k));
  return m * strip.tension * strip.height;
}

}  // namespace zona::studies::references
