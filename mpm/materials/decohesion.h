#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "mpm/materials/elastic_moduli.h"

namespace zona::mpm {

/// Method to find the direction of a discontinuity in a membrane.
enum class Localization {
  plane_stress,  ///< plane_stress_bifurcation: the normal lies in the membrane
  source         ///< source_membrane_bifurcation
};

/// Decohesion (5.32)-(5.42): once plastic flow has localised, a surface with a fixed normal opens
/// at the point, and its traction falls to zero.
struct Decohesion {
  double reference_opening = 1e-8;  ///< u_0 [m]
  double exponent = 1;              ///< q, at least 1
  /// c_m, shear strength over tensile strength of the surface. Large values fail by opening
  /// (mode I), small ones by sliding (mode II), as the source says below (5.40); the ratio
  /// tau_nf/tau_tf printed there would do the opposite.
  double mode_ratio = 10;
  /// tau_0 [Pa]; 0 stands for the magnitude of the traction at which the surface appears.
  double reference_traction = 0;
  /// Edges of the grid's cells [m], which determine the effective length.
  Eigen::Vector3d cell = Eigen::Vector3d::Constant(6e-6);
  Localization localization = Localization::plane_stress;  ///< of membranes
};

/// Throws ModelError for values out of range.
void check(const Decohesion& model);

/// L_e of (5.35) [m]: volume of a cell over the area of its cut with the plane through its centre
/// that has this unit normal. Between 0.7 and 1 edges in a cube.
double effective_length(const Eigen::Vector3d& normal, const Eigen::Vector3d& cell);

/// Traction on a surface [Pa], or its opening [m].
struct SurfaceVector {
  double normal;      ///< along the normal
  double tangential;  ///< along the surface
};

/// A surface of decohesion.
struct DecohesionSurface {
  double tensile_strength = 0;    ///< tau_nf [Pa]; 0 where there is no surface
  double reference_traction = 0;  ///< tau_0 [Pa]

  bool present() const { return tensile_strength > 0; }  ///< true if there is a surface
  /// Energy of a resolved opening, u_0 tau_0 q/(q + 1) [J/m^2].
  double energy(const Decohesion& model) const {
    return model.reference_opening * reference_traction * model.exponent / (model.exponent + 1);
  }
};

/// Surface whose strengths satisfy (5.40) at the traction of the bifurcation [Pa]. A compressive
/// normal traction counts as zero: a closed surface fails by sliding.
DecohesionSurface surface_at(const Decohesion& model, const SurfaceVector& traction);

/// Direction m and effective traction tau^e of decohesion.
struct DecohesionFlow {
  SurfaceVector direction;  ///< m of (5.37) [m]; compression does not open the surface
  double effective;         ///< tau^e of (5.38) [J/m^2]
};
/// Direction and effective traction at this traction on a surface [Pa].
DecohesionFlow decohesion_flow(const Decohesion& model, const DecohesionSurface& surface,
                               const SurfaceVector& traction);

/// One-step update (5.41): increment of lambda^d from `lambda` for a trial state with the effective
/// traction `effective` [J/m^2]; zero where F^d <= tol. `relief`, m.Q.m / L_e [J/m^2], is the loss
/// of effective traction per lambda^d at fixed strain. If it does not exceed the loss of the
/// surface's strength, (5.41) gives a negative or unbounded answer: the softening snaps back and
/// the point fails at once, with the increment 1 - lambda.
///
/// One update reaches F^d = 0 if the direction of the traction stays. Materials repeat it from the
/// updated state until F^d = 0; they approach from outside, because F^d is convex. No increment
/// exceeds `at_axis`, at which the traction along the surface vanishes; beyond, it would change
/// sign and oscillate.
double decohesion_increment(const Decohesion& model, const DecohesionSurface& surface,
                            double lambda, double effective, double relief, double at_axis);

/// Greatest number of updates (5.41) per step; the next step continues with the rest.
inline constexpr int max_decohesion_updates = 30;

/// Largest effective length [m] at which a surface under this traction [Pa] opens gradually; beyond
/// it the softening snaps back. `stiffness` [Pa] is that of n.E.n against a normal and a tangential
/// opening.
double longest_resolved_length(const Decohesion& model, const DecohesionSurface& surface,
                               const SurfaceVector& traction, const SurfaceVector& stiffness);

}  // namespace zona::mpm
