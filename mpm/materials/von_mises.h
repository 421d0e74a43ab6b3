#pragma once

#include <optional>

#include "mpm/materials/decohesion.h"
#include "mpm/points/plane_tensor.h"

namespace zona::mpm {

/// Associated von Mises plasticity (5.12)-(5.15): the equivalent stress sqrt(3 J2) does not exceed
/// a strength that rises linearly to a peak and then falls linearly to zero.
///
/// The internal variable I_s of (5.15) is the path length of the plastic strain, dI = |d eps_p|,
/// not the equivalent plastic strain of textbooks, which is sqrt(2/3) of it. (5.14) and (5.15)
/// print d eps_p = dlambda df/dsigma and dI = dlambda, which contradict each other; (5.16)-(5.20)
/// mean the unit tensor N of (5.17): d eps_p = dI N.
struct VonMises {
  double yield_strength;         ///< sigma_y [Pa]
  double peak_strength;          ///< sigma_p [Pa]; the yield strength where nothing hardens
  double hardening_modulus = 0;  ///< E_h [Pa]
  double softening_modulus = 0;  ///< E_s [Pa], positive where the strength falls
  std::optional<Decohesion> decohesion{};  ///< follows where the plastic flow localises

  /// Neither hardens nor softens; its strength [Pa].
  static VonMises perfectly_plastic(double strength) { return {strength, strength}; }

  /// I_p, the internal variable at the peak [-].
  double peak_strain() const {
    return peak_strength > yield_strength ? (peak_strength - yield_strength) / hardening_modulus
                                          : 0;
  }
  /// What the equivalent stress may be at an internal variable (5.13) [Pa].
  double strength(double internal) const;
};

/// Throws ModelError.
void check(const VonMises& model);

/// H of (5.23) [1/Pa] for a strength that changes by `modulus` = E_h or -E_s:
/// -(1/N) df/dI is sqrt(2/3) times the modulus, because f is 3 J2 - strength^2. Negative where the
/// strength falls faster than the elastic stress, 2 G + sqrt(2/3) modulus < 0: such softening snaps
/// back at a point already.
double tangent_coefficient(double modulus, double shear_modulus, double j2);

/// What the plastic flow of a step came to.
struct PlasticFlow {
  double equivalent_stress;  ///< [Pa]
  double increment;          ///< of the internal variable [-]
};

/// The point where an equivalent stress of `trial` [Pa] above the strength meets it again when it
/// falls by `stiffness` [Pa] per internal variable, exactly, also across the peak and where nothing
/// is left of the strength. Where softening snaps back nothing is left at once.
PlasticFlow return_along(const VonMises& model, double trial, double internal, double stiffness);

/// `stiffness` of the radial return in three dimensions, sqrt(6) G [Pa].
double radial_stiffness(double shear_modulus);

/// sqrt(3 J2) in plane stress [Pa].
double equivalent_stress(const PlaneTensor& stress);

/// The plastic flow of a step in plane stress (Simo and Taylor 1986). In the sum and difference of
/// the normal stresses, and in the shear, the implicit step is diagonal: each shrinks by
/// 1/(1 + c x) with the plastic multiplier x. The path is told by a parameter t from 0 (the trial
/// stress) to 1 (no stress left), x = t / (2 G (1 - t)).
class PlaneStressFlow {
 public:
  /// From the trial stress [Pa].
  PlaneStressFlow(const PlaneTensor& trial, const ElasticModuli& moduli);

  PlaneTensor stress(double t) const;          ///< [Pa]
  PlaneTensor plastic_strain(double t) const;  ///< of the step so far [-]
  double equivalent_stress(double t) const;    ///< [Pa]
  double increment(double t) const;            ///< of the internal variable [-]

  /// Where the path meets the strength; 1 where nothing of it is left. The trial stress must be
  /// above the strength.
  double end(const VonMises& model, double internal) const;
  /// Where the internal variable has grown by `increment`; 1 when it never does.
  double at_increment(double increment) const;

 private:
  double meets_line(double strength, double modulus) const;

  double sum_, difference_, shear_;  ///< (xx + yy)/sqrt(2), (yy - xx)/sqrt(2), xy of the trial
  double two_g_;
  double ratio_;  ///< of the two shrinking rates, E / (3 (1 - nu)) over 2 G
};

}  // namespace zona::mpm
