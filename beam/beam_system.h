#pragma once

#include <Eigen/Core>
#include <vector>

#include "beam/pipette.h"
#include "beam/section.h"
#include "beam/symmetric_band.h"

namespace zona::beam {

/// How the beam is held. Both supports carry the prescribed motion g(t) at x = 0.
enum class Supports {
  clamped_free,   ///< deflection g and rotation 0 at x = 0, free at x = length (5.59)-(5.62)
  pinned_pinned,  ///< deflection g at x = 0 and 0 at x = length, no moments (Figure 5.25)
};

/// Semi-discrete equations of a beam on a moving support, in coordinates *relative* to the support:
///
///     v(x, t) = v*(x, t) + r(x) g(t)                                              (5.73), (5.75)
///     M q'' + C q' + K q = -m g''(t),      C = alpha M + beta K,      m = M_full r
///
/// r(x) is the rigid motion that unit displacement of the support causes (1 clamped, 1 - x/l
/// pinned), which strains nothing, so g itself loads nothing. The degrees of freedom q are
/// deflection [m] and rotation [rad] at the vertices from x = 0 to x = length, without the
/// essential ones. Damping acts on the relative motion.
struct BeamSystem {
  SymmetricBand mass;            ///< consistent M: [kg], [kg m], [kg m^2]
  SymmetricBand stiffness;       ///< K: [N/m], [N], [N m]
  double damping_alpha = 0;      ///< [1/s]
  double damping_beta = 0;       ///< [s]
  Eigen::VectorXd support_mass;  ///< m: inertia felt when the support accelerates [kg], [kg m]
  std::vector<bool> rotation;    ///< which degrees of freedom are rotations, not deflections
  Eigen::VectorXd observation;   ///< v* at the observed point is observation . q
  double support_share = 1;      ///< r at the observed point
  double element_length = 0;     ///< [m]

  int size() const { return mass.size(); }  ///< number of degrees of freedom
};

/// Everything about a beam but its section.
struct BeamLayout {
  int elements = 20;                           ///< of equal length
  Supports supports = Supports::clamped_free;  ///< how the beam is held
  double observed_at = 0;                      ///< x of the point whose motion is recorded [m]
};

/// Hermite cubic Euler-Bernoulli elements (5.57) on a uniform mesh; EI and rho_bar at five Gauss
/// points per element, exact for linearly tapering diameters. Throws std::invalid_argument for a
/// section without positive length, rigidity and mass, no elements or an observed point outside the
/// beam.
BeamSystem assemble(const Section& section, const BeamLayout& layout);

/// The pipette clamped at its shank, observed at its tip.
BeamSystem cantilever(const Pipette& pipette);

/// The pipette's section simply supported at both ends and observed at the centre (Figure 5.25).
BeamSystem simply_supported(const Pipette& pipette);

}  // namespace zona::beam
