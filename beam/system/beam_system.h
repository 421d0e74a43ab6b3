#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "beam/algebra/symmetric_band.h"
#include "beam/pipette/pipette.h"
#include "beam/pipette/section.h"

namespace zona::beam {

/// How the beam is held. Both supports carry the prescribed motion g(t) at x = 0.
enum class Supports {
  clamped_free,   ///< deflection g and rotation 0 at x = 0, free at x = length (5.59)-(5.62)
  pinned_pinned,  ///< deflection g at x = 0 and 0 at x = length, no moments (Figure 5.25)
};

/// What the elements do.
enum class Deformation {
  bending,     ///< deflection across the axis: Hermite cubics, C1
  stretching,  ///< displacement along the axis: cubic Lagrange elements on Gauss-Lobatto nodes, C0
};

/// A point of the elements' quadrature: where, how much it counts, and what the shape functions are
/// there.
struct QuadraturePoint {
  static constexpr int dofs = 4;   ///< of an element
  static constexpr int held = -1;  ///< in place of the number of an essential degree of freedom

  double x = 0;                      ///< [m]
  double weight = 0;                 ///< [m]
  std::array<int, dofs> dof{};       ///< numbers of the degrees of freedom
  std::array<double, dofs> shape{};  ///< N at x
  double rigid = 0;                  ///< r at x, see BeamSystem
};

/// What a coefficient c(x) per length does to the beam: int c N N^T dx, and int c N r dx for the
/// rigid motion r with the support.
struct Distributed {
  SymmetricBand matrix;     ///< int c N N^T dx
  Eigen::VectorXd support;  ///< int c N r dx
};

/// The `viscous_load` f(s, a) of a liquid, as far as it is that of one radius. Where the radius
/// changes along the beam, f is interpolated between a few radii a_k, with Lagrange's polynomials
/// l_k(ln a(x)): the load is sum_k f(s, a_k) share_k.
struct ViscousLoad {
  Flow flow = Flow::across;                ///< where the liquid is
  Liquid liquid;                           ///< what it is
  double radius = 0;                       ///< a_k [m]
  BathModel model = BathModel::frequency;  ///< how it acts
  double angular_frequency = 0;            ///< of BathModel::constant [rad/s]
  Distributed share;                       ///< of l_k [m]
};

/// What the liquids around and in a beam do, beyond the mass that moves as the beam does.
struct LiquidLoads {
  std::vector<ViscousLoad> viscous;  ///< empty: there is no liquid
  Distributed displaced;             ///< of the displaced liquid's mass, rho pi a^2 [kg]
  /// Where the quadratic drag acts; the weights are rho C_D a [kg]. Empty: there is none.
  std::vector<QuadraturePoint> drag;

  bool act() const { return !viscous.empty(); }  ///< whether there is any
  /// Whether a liquid around the beam acts after this model.
  bool has_bath(BathModel model) const;
};

/// Semi-discrete equations of a beam on a moving support, in coordinates *relative* to the support:
///
///     v(x, t) = v*(x, t) + r(x) g(t)                                              (5.73), (5.75)
///     M q'' + C q' + K q = -m g''(t),      C = alpha M + beta K,      m = M_full r
///
/// r(x) is the rigid motion that unit displacement of the support causes (1 clamped, 1 - x/l
/// pinned), which strains nothing, so g itself loads nothing. The degrees of freedom q are
/// deflection [m] and rotation [rad] at the vertices from x = 0 to x = length, without the
/// essential ones. This damping acts on the relative motion; the liquids act on the absolute one,
/// v.
///
/// A rod that vibrates along itself (`axial_rod`) has the same equations, with axial displacements
/// as degrees of freedom, three per element, and r = 1.
struct BeamSystem {
  SymmetricBand mass;            ///< consistent M: [kg], [kg m], [kg m^2]
  SymmetricBand stiffness;       ///< K: [N/m], [N], [N m]
  double damping_alpha = 0;      ///< [1/s]
  double damping_beta = 0;       ///< [s]
  double loss_factor = 0;        ///< tan(delta) of K
  double loss_frequency = 0;     ///< angular frequency at which K is the storage stiffness [rad/s]
  Eigen::VectorXd support_mass;  ///< m: inertia felt when the support accelerates [kg], [kg m]
  std::vector<bool> rotation;    ///< which degrees of freedom are rotations, not deflections
  Eigen::VectorXd observation;   ///< v* at the observed point is observation . q
  double support_share = 1;      ///< r at the observed point
  double element_length = 0;     ///< mean [m]
  LiquidLoads liquids{};         ///< around and in the beam, if any

  int size() const { return mass.size(); }  ///< number of degrees of freedom
};

/// Everything about a beam but its section.
struct BeamLayout {
  int elements = 20;                           ///< of equal length, but for breaks of the section
  Supports supports = Supports::clamped_free;  ///< how the beam is held
  double observed_at = 0;                      ///< x of the point whose motion is recorded [m]
  Deformation deformation = Deformation::bending;  ///< stretching wants Supports::clamped_free
};

/// Hermite cubic Euler-Bernoulli elements (5.57), or cubic elements of a rod, rho_bar u_tt = (EA
/// u_x)_x, evenly long between the section's breaks; rigidity and rho_bar at five Gauss points per
/// element, exact for linearly tapering diameters. Throws std::invalid_argument for a section
/// without positive length, rigidity and mass, no elements, an observed point outside the beam or a
/// pinned rod.
BeamSystem assemble(const Section& section, const BeamLayout& layout);

/// The points at which `assemble` evaluates the section, from x = 0 on. Throws as it does.
std::vector<QuadraturePoint> quadrature_points(const Section& section, const BeamLayout& layout);

/// What a coefficient per length comes to for a beam of `size` degrees of freedom.
Distributed distribute(const std::vector<QuadraturePoint>& points, int size,
                       const std::function<double(double)>& coefficient);

/// The pipette clamped at its shank, observed at its tip.
BeamSystem cantilever(const Pipette& pipette);

/// The pipette as an elastic rod of glass along its axis, rho_bar u_tt = (EA u_x)_x, held by its
/// moving support and free at its tip, which is observed. The fluid in the bore is dragged along by
/// the wall's viscous layer (Flow::within), the bath rubs on the outside (Flow::along), without a
/// quadratic drag. Neglected are pressure along the bore, on the tip's face and on the walls of a
/// taper, and radial inertia (docs/theory/beam.md says how much they do).
BeamSystem axial_rod(const Pipette& pipette);

/// The pipette's section simply supported at both ends and observed at the centre (Figure 5.25).
BeamSystem simply_supported(const Pipette& pipette);

}  // namespace zona::beam
