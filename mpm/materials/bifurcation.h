#pragma once

#include <Eigen/Core>

#include "mpm/materials/elastic_moduli.h"

namespace zona::mpm {

/// First discontinuity of the velocity gradient that the associated von Mises model admits,
/// det(n . E_T . n) = 0 (5.24).
struct Bifurcation {
  /// Largest dk/dI (E_h or -E_s) at which the discontinuity exists [Pa]; never positive. This is
  /// the modulus of the strength, not H of (5.23), which is negative beyond the critical value
  /// where softening snaps back.
  double critical_modulus;
  /// Angle between the normal n of the discontinuity and the direction of the largest principal
  /// stress [rad], in the plane of the largest and the smallest; both signs are equally critical.
  double angle;
};

/// Bifurcation in three dimensions (5.28)-(5.31), for principal stresses [Pa] in descending order,
/// not all equal.
///
/// (5.29) is a cosine, cos 2 theta = 3 G (sigma_c - sigma_0) / ((G + 3K) r), and (5.30)-(5.31) is
/// the case in which it exceeds 1. The case below -1, with theta = 90 degrees, is missing in the
/// source. For K > 0 neither occurs, because |sigma_c - sigma_0| <= r/3: von Mises always localises
/// in shear.
Bifurcation bifurcation(const Eigen::Vector3d& principal_stress, const ElasticModuli& moduli);

/// Bifurcation in plane stress, for the in-plane principal stresses [Pa], first >= second, not both
/// zero. The normal lies in the plane, as it must in a membrane: the determinant is that of the
/// 2 x 2 acoustic tensor of the plane stress tangent. The critical modulus is -sqrt(3/2) E N_tt^2,
/// where N_tt is the component of the unit flow direction N (5.17) along the line of discontinuity;
/// the elastic surroundings resist the plastic strain along that line. The modulus vanishes at
/// tan^2 theta = -N_2/N_1, unless both in-plane deviatoric stresses have the same sign.
Bifurcation plane_stress_bifurcation(double first, double second, const ElasticModuli& moduli);

/// (5.29) with a third principal stress of zero and theta laid into the plane, as the source seems
/// to treat membranes. If both stresses are tensile, the direction of the smallest one is the
/// thickness.
Bifurcation source_membrane_bifurcation(double first, double second, const ElasticModuli& moduli);

/// True if a strength with the modulus dk/dI = `modulus` [Pa] is at or beyond the bifurcation, up
/// to rounding.
bool loses_ellipticity(double modulus, const Bifurcation& bifurcation, const ElasticModuli& moduli);

/// H^cr of (5.28) and (5.30) [1/Pa].
double critical_coefficient(const Eigen::Vector3d& principal_stress, const ElasticModuli& moduli);

}  // namespace zona::mpm
