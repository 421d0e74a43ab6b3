#pragma once

#include <Eigen/Core>

#include "mpm/materials/elastic_moduli.h"

namespace zona::mpm {

/// Where and when the associated von Mises model first admits a discontinuity of the velocity
/// gradient, det(n . E_T . n) = 0 (5.24).
struct Bifurcation {
  /// The largest dk/dI (E_h or -E_s) at which it does [Pa]; never positive. The strength's modulus
  /// is compared, not H of (5.23): where softening snaps back H is negative although the critical
  /// value was passed.
  double critical_modulus;
  /// Between the normal n of the discontinuity and the direction of the largest principal stress
  /// [rad], in the plane of the largest and the smallest; both signs are equally critical.
  double angle;
};

/// Three dimensions (5.28)-(5.31), for principal stresses in descending order, not all equal.
///
/// (5.29) is a cosine, cos 2 theta = 3 G (sigma_c - sigma_0) / ((G + 3K) r), and (5.30)-(5.31) is
/// where it exceeds 1. It would fall below -1 where the smallest stress governs, theta = 90
/// degrees, a branch that the source does not have. For K > 0 neither ever happens, because
/// |sigma_c - sigma_0| <= r/3: von Mises always localises in shear.
Bifurcation bifurcation(const Eigen::Vector3d& principal_stress, const ElasticModuli& moduli);

/// Plane stress, for the principal stresses in the plane, first >= second, not both zero. The
/// normal lies in the plane, as it must in a membrane: the determinant is that of the 2 x 2
/// acoustic tensor of the plane stress tangent. The critical modulus is -sqrt(3/2) E N_tt^2, with
/// N_tt the component of the unit flow direction N (5.17) along the line of discontinuity: the
/// plastic strain along that line is what the elastic surroundings resist. It can vanish, at
/// tan^2 theta = -N_2/N_1, unless both in-plane deviatoric stresses have one sign.
Bifurcation plane_stress_bifurcation(double first, double second, const ElasticModuli& moduli);

/// (5.29) with the third principal stress zero, theta then laid into the plane: what the source
/// seems to do with membranes. Where both stresses are tensile its direction of the smallest stress
/// is the thickness.
Bifurcation source_membrane_bifurcation(double first, double second, const ElasticModuli& moduli);

/// Whether a strength that changes by `modulus` [Pa] is at or beyond the bifurcation, to rounding.
bool loses_ellipticity(double modulus, const Bifurcation& bifurcation, const ElasticModuli& moduli);

/// H^cr of (5.28) and (5.30) [1/Pa].
double critical_coefficient(const Eigen::Vector3d& principal_stress, const ElasticModuli& moduli);

}  // namespace zona::mpm
