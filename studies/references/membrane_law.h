#pragma once

namespace zona::studies::references {

/// Strain of a stretch lambda.
enum class StrainMeasure {
  biot,        ///< lambda - 1
  logarithmic  ///< ln lambda
};

/// Stress measure of Hooke's law.
enum class StressMeasure {
  kirchhoff,  ///< force per current width times current over undeformed volume: what the material
              ///< point method computes, where a point keeps its volume mass/density
  nominal     ///< force per undeformed width
};

/// Treatment of compression.
enum class Wrinkling {
  none,    ///< carries compression
  stress,  ///< taut, wrinkled (uniaxial stress) or slack: Pipkin's relaxed energy
  strain   ///< the source's: negative principal strains are zeroed before the plane-stress law
};

/// Linear elastic isotropic membrane in plane stress.
///
/// With the undeformed thickness h, the tensions per *undeformed* width are
///   P_i = h tau_i/lambda_i (Kirchhoff), P_i = h tau_i (nominal),
/// because the power of the stress is h (tau_1 rate(lambda_1)/lambda_1 + ...) per undeformed area
/// in the first, h (tau_1 rate(lambda_1) + ...) in the second case. Logarithmic with Kirchhoff and
/// Biot with nominal are conjugate and derive from a stored energy. Biot with Kirchhoff, which the
/// material point method has with objective kinematics, does not: dP_1/dlambda_2 = h E' nu/lambda_1
/// differs from dP_2/dlambda_1 = h E' nu/lambda_2, by the square of the strains.
struct MembraneLaw {
  double youngs_modulus;  ///< E [Pa]
  double poisson_ratio;   ///< nu [-]
  double thickness;       ///< undeformed, h [m]
  StrainMeasure strain = StrainMeasure::logarithmic;
  StressMeasure stress = StressMeasure::kirchhoff;
  Wrinkling wrinkling = Wrinkling::stress;

  bool has_energy() const {
    return (strain == StrainMeasure::logarithmic) == (stress == StressMeasure::kirchhoff) &&
           wrinkling != Wrinkling::strain;
  }
};

/// Throws ModelError unless E and h are positive and -1 < nu < 1.
void check(const MembraneLaw& law);

enum class MembraneState { taut, wrinkled, slack };

/// Strain [-] of a stretch and its derivative.
struct StrainOf {
  double value, derivative;
};
StrainOf strain_of(StrainMeasure measure, double stretch);
/// The stretch of a strain.
double stretch_of(StrainMeasure measure, double strain);

/// Principal stresses of the law at principal strains (in any order).
///   taut:     tau_1 = E (e_1 + nu e_2)/(1 - nu^2), if neither is negative
///   wrinkled: uniaxial, tau = E e along the larger strain, if that is positive
///   slack:    none
/// `Wrinkling::strain` is the law of "taut" at max(e_1, 0), max(e_2, 0) instead.
struct PrincipalStresses {
  double first, second;       ///< [Pa]
  double d11, d12, d21, d22;  ///< d first/d e_1, d first/d e_2, d second/... [Pa]
  MembraneState state;
};
PrincipalStresses principal_stresses(const MembraneLaw& law, double e1, double e2);

/// Tensions per undeformed width [N/m] along the principal stretches, and their derivatives.
struct MembraneTensions {
  double first, second;
  double d11, d12, d21, d22;  ///< d first/d lambda_1, d first/d lambda_2, d second/... [N/m]
  MembraneState state;
};
MembraneTensions membrane_tensions(const MembraneLaw& law, double stretch1, double stretch2);

/// Stored energy per undeformed area [J/m^2]. Throws ModelError for a law that has none.
double stored_energy(const MembraneLaw& law, double stretch1, double stretch2);

}  // namespace zona::studies::references
