#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "mpm/materials/elastic_moduli.h"

namespace zona::mpm {

/// How the direction of a discontinuity in a membrane is found.
enum class Localization {
  plane_stress,  ///< plane_stress_bifurcation: the normal lies in the membrane
  source         ///< source_membrane_bifurcation
};

/// Decohesion (5.32)-(5.42): once the flow has localised, a surface of fixed normal opens at the
/// point, and its traction falls to zero.
struct Decohesion {
  double reference_opening = 1e-8;  ///< u_0 [m]
  double exponent = 1;              ///< q, at least 1
  /// c_m: the shear strength over the tensile strength of the surface. Large values fail by
  /// opening (mode I), small ones by sliding (mode II), as the source says below (5.40); the
  /// tau_nf/tau_tf that it prints there would do the opposite.
  double mode_ratio = 10;
  /// tau_0 [Pa]; 0 is the magnitude of the traction at which the surface appears.
  double reference_traction = 0;
  /// Edges of the cells of the background grid [m], which give the effective length.
  Eigen::Vector3d cell = Eigen::Vector3d::Constant(6e-6);
  Localization localization = Localization::plane_stress;  ///< of membranes
};

/// Throws ModelError.
void check(const Decohesion& model);

/// L_e of (5.35) [m]: the volume of a cell over the area in which a plane with this unit normal
/// through its middle cuts it. Between 0.7 and 1 edges in a cube.
double effective_length(const Eigen::Vector3d& normal, const Eigen::Vector3d& cell);

/// Traction on a surface [Pa], or opening of it [m]: along the normal, and along the surface.
struct SurfaceVector {
  double normal;      ///< along the normal
  double tangential;  ///< along the surface
};

/// A surface that opens.
struct DecohesionSurface {
  double tensile_strength = 0;    ///< tau_nf [Pa]; 0 where there is no surface
  double reference_traction = 0;  ///< tau_0 [Pa]

  bool present() const { return tensile_strength > 0; }  ///< there is a surface
  /// u_0 tau_0 q/(q + 1) [J/m^2]: what opening it takes, if it is resolved.
  double energy(const Decohesion& model) const {
    return model.reference_opening * reference_traction * model.exponent / (model.exponent + 1);
  }
};

/// The strengths with which (5.40) holds at the traction of the bifurcation. A compressive normal
/// traction counts as none: a closed surface fails by sliding.
DecohesionSurface surface_at(const Decohesion& model, const SurfaceVector& traction);

/// m of (5.37) [m], which compression does not open, and tau^e of (5.38) [J/m^2].
struct DecohesionFlow {
  SurfaceVector direction;  ///< m [m]
  double effective;         ///< tau^e [J/m^2]
};
/// At this traction on a surface [Pa].
DecohesionFlow decohesion_flow(const Decohesion& model, const DecohesionSurface& surface,
                               const SurfaceVector& traction);

/// The one-step update (5.41): by how much lambda^d grows from `lambda` when the trial state has
/// the effective traction `effective`; zero where F^d <= tol. `relief` is m.Q.m / L_e [J/m^2], what
/// the effective traction loses per lambda^d at fixed strain. Where that is not more than what the
/// surface's strength loses, the answer of (5.41) is negative or unbounded: the softening snaps
/// back, and the point fails at once: 1 - lambda.
///
/// One step of it meets F^d = 0 where the direction of the traction stays. Materials take the
/// step again, from where it led to, until it does: F^d is convex, so that they come from outside.
/// No step goes beyond `at_axis`, where the traction along the surface vanishes: it would turn
/// round and swing.
double decohesion_increment(const Decohesion& model, const DecohesionSurface& surface,
                            double lambda, double effective, double relief, double at_axis);

/// How often a material repeats (5.41) in a step at most; what is left waits for the next step.
inline constexpr int most_repetitions = 30;

/// Largest effective length at which a surface under this traction opens gradually until it has
/// opened [m]; beyond it the softening snaps back. `stiffness` is that of n.E.n against a normal
/// and a tangential opening [Pa].
double longest_resolved_length(const Decohesion& model, const DecohesionSurface& surface,
                               const SurfaceVector& traction, const SurfaceVector& stiffness);

}  // namespace zona::mpm
