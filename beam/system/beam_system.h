#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "beam/algebra/symmetric_band.h"
#include "beam/pipette/pipette.h"
#include "beam/pipette/section.h"

namespace zona::beam {

/// Supports of a beam. In both cases the end x = 0 has the prescribed motion g(t).
enum class Supports {
  clamped_free,   ///< deflection g and rotation 0 at x = 0, free at x = length (5.59)-(5.62)
  pinned_pinned,  ///< deflection g at x = 0 and 0 at x = length, no moments (Figure 5.25)
};

/// Deformation that the elements describe.
enum class Deformation {
  bending,     ///< deflection across the axis: Hermite cubics, C1
  stretching,  ///< displacement along the axis: cubic Lagrange elements on Gauss-Lobatto nodes, C0
};

/// A quadrature point of the elements: position, weight and shape functions.
struct QuadraturePoint {
  static constexpr int dofs = 4;   ///< degrees of freedom of an element
  static constexpr int held = -1;  ///< index of an essential degree of freedom

  double x = 0;                      ///< [m]
  double weight = 0;                 ///< [m]
  std::array<int, dofs> dof{};       ///< indices of the degrees of freedom
  std::array<double, dofs> shape{};  ///< N at x
  double rigid = 0;                  ///< r at x, see BeamSystem
};

/// A coefficient c(x) per length, integrated over the beam with the shape functions N and the rigid
/// motion r with the support.
struct Distributed {
  SymmetricBand matrix;     ///< int c N N^T dx
  Eigen::VectorXd support;  ///< int c N r dx
};

/// One term of the `viscous_load` f(s, a) of a liquid. Where the radius changes along the beam, f
/// is interpolated between a few radii a_k with the Lagrange polynomials l_k(ln a(x)): the load is
/// sum_k f(s, a_k) share_k.
struct ViscousLoad {
  Flow flow = Flow::across;                ///< position and direction of the flow
  Liquid liquid;                           ///< density and viscosity
  double radius = 0;                       ///< a_k [m]
  BathModel model = BathModel::frequency;  ///< dependence on frequency
  double angular_frequency = 0;            ///< of BathModel::constant [rad/s]
  Distributed share;                       ///< l_k, distributed [m]
};

/// Loads by the liquids around and in a beam, besides fill that moves with the beam.
struct LiquidLoads {
  std::vector<ViscousLoad> viscous;  ///< empty without liquids
  Distributed displaced;             ///< mass of the displaced liquid, rho pi a^2, distributed [kg]
  /// Points with quadratic drag; their weights are rho C_D a dx [kg]. Empty without it.
  std::vector<QuadraturePoint> drag;

  bool act() const { return !viscous.empty(); }  ///< true if there are any
  /// True if the liquid around the beam has this model.
  bool has_bath(BathModel model) const;
};

/// Semi-discrete equations of a beam on a moving support, in coordinates *relative* to the support:
///
///     v(x, t) = v*(x, t) + r(x) g(t)                                              (5.73), (5.75)
///     M q'' + C q' + K q = -m g''(t),      C = alpha M + beta K,      m = M_full r
///
/// r(x) is the rigid motion for unit displacement of the support (1 clamped, 1 - x/l pinned). It
/// causes no strain, so that only the acceleration of g loads the beam. The degrees of freedom q
/// are deflection [m] and rotation [rad] at the vertices from x = 0 to x = length, without the
/// essential ones. The damping C acts on the relative motion, the liquids on the absolute motion v.
///
/// A rod that vibrates along its axis (`axial_rod`) has the same equations with axial displacements
/// as degrees of freedom, three per element, and r = 1.
struct BeamSystem {
  SymmetricBand mass;            ///< consistent M: [kg], [kg m], [kg m^2]
  SymmetricBand stiffness;       ///< K: [N/m], [N], [N m]
  double damping_alpha = 0;      ///< [1/s]
  double damping_beta = 0;       ///< [s]
  double loss_factor = 0;        ///< tan(delta) of K
  double loss_frequency = 0;     ///< angular frequency at which K is the storage stiffness [rad/s]
  Eigen::VectorXd support_mass;  ///< m, inertia for accelerations of the support [kg], [kg m]
  std::vector<bool> rotation;    ///< true for degrees of freedom that are rotations
  Eigen::VectorXd observation;   ///< v* at the observed point is observation . q
  double support_share = 1;      ///< r at the observed point
  double element_length = 0;     ///< mean [m]
  LiquidLoads liquids{};         ///< loads by liquids

  int size() const { return mass.size(); }  ///< number of degrees of freedom
};

/// Mesh, supports and observed point of a beam.
struct BeamLayout {
  int elements = 20;                           ///< of equal length between breaks of the section
  Supports supports = Supports::clamped_free;  ///< supports of the beam
  double observed_at = 0;                      ///< x of the observed point [m]
  Deformation deformation = Deformation::bending;  ///< stretching needs Supports::clamped_free
};

/// Assembles Hermite cubic Euler-Bernoulli elements (5.57), or cubic elements of a rod,
/// rho_bar u_tt = (EA u_x)_x, of equal length between the section's breaks. Evaluates rigidity and
/// rho_bar at five Gauss points per element, which is exact for linearly tapering diameters. Throws
/// std::invalid_argument unless length, rigidity, mass and number of elements are positive, the
/// observed point lies on the beam, and a rod is clamped.
BeamSystem assemble(const Section& section, const BeamLayout& layout);

/// The points at which `assemble` evaluates the section, by increasing x. Throws as it does.
std::vector<QuadraturePoint> quadrature_points(const Section& section, const BeamLayout& layout);

/// Integrates a coefficient per length for a beam of `size` degrees of freedom.
Distributed distribute(const std::vector<QuadraturePoint>& points, int size,
                       const std::function<double(double)>& coefficient);

/// The pipette clamped at its shank, observed at its tip. Throws as `check` does.
BeamSystem cantilever(const Pipette& pipette);

/// The pipette as an elastic rod of glass along its axis, rho_bar u_tt = (EA u_x)_x, held by its
/// moving support and free at its tip, which is observed. The wall's viscous layer drags the fluid
/// in the bore (Flow::within), and the bath acts on the outside (Flow::along), without quadratic
/// drag. Neglects pressure along the bore, on the face of the tip and on the walls of a taper, and
/// radial inertia (docs/theory/beam.md estimates their effects). Throws as `check` does.
BeamSystem axial_rod(const Pipette& pipette);

/// The pipette's section simply supported at both ends and observed at the centre (Figure 5.25).
/// Throws as `check` does.
BeamSystem simply_supported(const Pipette& pipette);

}  // namespace zona::beam
