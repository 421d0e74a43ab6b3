#pragma once

#include <functional>
#include <vector>

namespace zona::beam {

/// Cross-section of a straight beam along its axis x [m], 0 <= x <= length. The finite elements
/// evaluate it at their quadrature points only, so taper or a partial fill need no other change.
struct Section {
  double length = 0;                                ///< [m]
  std::function<double(double)> flexural_rigidity;  ///< EI(x) [N m^2]
  std::function<double(double)> mass_per_length;    ///< rho_bar(x) [kg/m]
  /// Where something jumps or kinks [m], in any order: elements end there. Those outside the beam
  /// or nearer than 1e-6 lengths to its ends or to another are left out.
  std::vector<double> breaks{};
  std::function<double(double)> axial_rigidity{};  ///< EA(x) [N]; needed by Deformation::stretching
};

/// Beam with the same cross-section everywhere: what the analytic solutions of 5.5 need.
struct UniformBeam {
  double length = 0;             ///< [m]
  double flexural_rigidity = 0;  ///< EI [N m^2]
  double mass_per_length = 0;    ///< rho_bar [kg/m]

  /// c = sqrt(EI / rho_bar) [m^2/s], as used in (5.72).
  double dispersion() const;
};

/// The same beam for the finite elements.
Section section_of(const UniformBeam& beam);

}  // namespace zona::beam
