#include "studies/references/membrane_law.h"

#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

void check(const MembraneLaw& law) {
  require_positive(law.youngs_modulus, "Young's modulus");
  require_positive(law.thickness, "thickness");
  require(law.poisson_ratio > -1 && law.poisson_ratio < 1,
          "Poisson's ratio must be in (-1, 1), not " + std::to_string(law.poisson_ratio));
}

StrainOf strain_of(StrainMeasure measure, double stretch) {
  if (measure == StrainMeasure::biot) return {stretch - 1, 1};
  return {std::log(stretch), 1 / stretch};
}

double stretch_of(StrainMeasure measure, double strain) {
  return measure == StrainMeasure::biot ? 1 + strain : std::exp(strain);
}

namespace {

/// The source's one-way law: each strain counts while it is positive.
PrincipalStresses cut_strains(double plane, double nu, double e1, double e2) {
  const double on1 = e1 > 0, on2 = e2 > 0;
  const double s1 = plane * (on1 * e1 + nu * on2 * e2), s2 = plane * (on2 * e2 + nu * on1 * e1);
  const MembraneState state = on1 + on2 == 2   ? MembraneState::taut
                              : on1 + on2 == 1 ? MembraneState::wrinkled
                                               : MembraneState::slack;
  return {s1, s2, plane * on1, nu * plane * on2, nu * plane * on1, plane * on2, state};
}

}  // namespace

PrincipalStresses principal_stresses(const MembraneLaw& law, double e1, double e2) {
  const double nu = law.poisson_ratio, e = law.youngs_modulus, plane = e / (1 - nu * nu);
  if (law.wrinkling == Wrinkling::strain) return cut_strains(plane, nu, e1, e2);
  const double s1 = plane * (e1 + nu * e2), s2 = plane * (e2 + nu * e1);
  if (law.wrinkling == Wrinkling::none || (s1 >= 0 && s2 >= 0)) {
    return {s1, s2, plane, nu * plane, nu * plane, plane, MembraneState::taut};
  }
  if (e1 >= e2 && e1 > 0) return {e * e1, 0, e, 0, 0, 0, MembraneState::wrinkled};
  if (e2 > e1 && e2 > 0) return {0, e * e2, 0, 0, 0, e, MembraneState::wrinkled};
  return {0, 0, 0, 0, 0, 0, MembraneState::slack};
}

MembraneTensions membrane_tensions(const MembraneLaw& law, double stretch1, double stretch2) {
  const StrainOf e1 = strain_of(law.strain, stretch1), e2 = strain_of(law.strain, stretch2);
  const PrincipalStresses s = principal_stresses(law, e1.value, e2.value);
  const bool kirchhoff = law.stress == StressMeasure::kirchhoff;
  const double a1 = law.thickness / (kirchhoff ? stretch1 : 1.0);
  const double a2 = law.thickness / (kirchhoff ? stretch2 : 1.0);
  MembraneTensions t{a1 * s.first,
                     a2 * s.second,
                     a1 * s.d11 * e1.derivative,
                     a1 * s.d12 * e2.derivative,
                     a2 * s.d21 * e1.derivative,
                     a2 * s.d22 * e2.derivative,
                     s.state};
  if (kirchhoff) {
    t.d11 -= t.first / stretch1;
    t.d22 -= t.second / stretch2;
  }
  return t;
}

double stored_energy(const MembraneLaw& law, double stretch1, double stretch2) {
  require(law.has_energy(),
          "this law stores no energy: take logarithmic strain with Kirchhoff stress, or Biot "
          "strain with nominal stress, and no cut strains");
  const double e1 = strain_of(law.strain, stretch1).value;
  const double e2 = strain_of(law.strain, stretch2).value;
  const PrincipalStresses s = principal_stresses(law, e1, e2);
  // Uniaxial stress does no work on the wrinkled direction.
  return 0.5 * law.thickness * (s.first * e1 + s.second * e2);
}

}  // namespace zona::studies::references
