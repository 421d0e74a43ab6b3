#pragma once

#include <optional>

#include "mpm/materials/decohesion.h"
#include "mpm/points/plane_tensor.h"

namespace zona::mpm {

/// Associated von Mises plasticity (5.12)-(5.15): the equivalent stress sqrt(3 J2) does not exceed
/// a strength that rises linearly to a peak and then falls linearly to zero.
///
/// The internal variable I_s of (5.15) is the path length of the plastic strain, dI = |d eps_p|.
/// The equivalent plastic strain of textbooks is sqrt(2/3) of it. (5.14) and (5.15) print d eps_p =
/// dlambda df/dsigma and dI = dlambda, which contradict each other; (5.16)-(5.20) mean d eps_p = dI
/// N with the unit tensor N of (5.17).
struct VonMises {
  double yield_strength;         ///< sigma_y [Pa]
  double peak_strength;          ///< sigma_p [Pa]; the yield strength if there is no hardening
  double hardening_modulus = 0;  ///< E_h [Pa]
  double softening_modulus = 0;  ///< E_s [Pa], positive where the strength falls
  std::optional<Decohesion> decohesion{};  ///< starts when the plastic flow localises

  /// Perfect plasticity with this strength [Pa].
  static VonMises perfectly_plastic(double strength) { return {strength, strength}; }

  /// I_p, the internal variable at the peak [-].
  double peak_strain() const {
    return peak_strength > yield_strength ? (peak_strength - yield_strength) / hardening_modulus
                                          : 0;
  }
  /// Limit of the equivalent stress at an internal variable (5.13) [Pa].
  double strength(double internal) const;
};

/// Throws ModelError for values out of range.
void check(const VonMises& model);

/// H of (5.23) [1/Pa] for a strength with the modulus dk/dI = E_h or -E_s [Pa]:
/// -(1/N) df/dI is sqrt(2/3) times the modulus, because f is 3 J2 - strength^2. H is negative if
/// the strength falls faster than the elastic stress, 2 G + sqrt(2/3) modulus < 0; such softening
/// snaps back even at a single point.
double tangent_coefficient(double modulus, double shear_modulus, double j2);

/// Result of the plastic flow of a step.
struct PlasticFlow {
  double equivalent_stress;  ///< [Pa]
  double increment;          ///< of the internal variable [-]
};

/// Exact return of an equivalent stress `trial` [Pa] above the strength, which falls by `stiffness`
/// [Pa] per unit of the internal variable until it meets the strength; also across the peak and
/// down to zero strength. Where softening snaps back, the stress falls to zero at once.
PlasticFlow return_along(const VonMises& model, double trial, double internal, double stiffness);

/// `stiffness` of the radial return in three dimensions, sqrt(6) G [Pa].
double radial_stiffness(double shear_modulus);

/// sqrt(3 J2) in plane stress [Pa].
double equivalent_stress(const PlaneTensor& stress);

/// Plastic flow of a step in plane stress (Simo and Taylor 1986). The implicit step is diagonal in
/// the sum and difference of the normal stresses and in the shear stress: each shrinks by
/// 1/(1 + c x) with the plastic multiplier x. The parameter t runs along the path from 0 (trial
/// stress) to 1 (zero stress), x = t / (2 G (1 - t)).
class PlaneStressFlow {
 public:
  /// Path from the trial stress [Pa].
  PlaneStressFlow(const PlaneTensor& trial, const ElasticModuli& moduli);

  PlaneTensor stress(double t) const;          ///< [Pa]
  PlaneTensor plastic_strain(double t) const;  ///< since the start of the step [-]
  double equivalent_stress(double t) const;    ///< [Pa]
  double increment(double t) const;            ///< of the internal variable [-]

  /// t at which the path meets the strength; 1 if the strength has fallen to zero. The trial stress
  /// must exceed the strength.
  double end(const VonMises& model, double internal) const;
  /// t at which the internal variable has grown by `increment`; 1 if it never does.
  double at_increment(double increment) const;

 private:
  double intersect_line(double strength, double modulus) const;

  double sum_, difference_, shear_;  ///< (xx + yy)/sqrt(2), (yy - xx)/sqrt(2), xy of the trial
  double two_g_;
  double ratio_;  ///< ratio r of the two rates of decrease, E / (3 (1 - nu)) over 2 G
};

}  // namespace zona::mpm
