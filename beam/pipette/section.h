#pragma once

#include <functional>
#include <vector>

namespace zona::beam {

/// Cross-section of a straight beam along its axis x [m], 0 <= x <= length. The finite elements
/// evaluate it only at their quadrature points, so it can vary in any way.
struct Section {
  double length = 0;                                ///< [m]
  std::function<double(double)> flexural_rigidity;  ///< EI(x) [N m^2]
  std::function<double(double)> mass_per_length;    ///< rho_bar(x) [kg/m]
  /// Positions of jumps and kinks [m], in any order; elements end there. Breaks outside the beam,
  /// or within 1e-6 lengths of its ends or of another break, are ignored.
  std::vector<double> breaks{};
  std::function<double(double)> axial_rigidity{};  ///< EA(x) [N]; needed by Deformation::stretching
};

/// Beam with a uniform cross-section, for the analytic solutions of 5.5.
struct UniformBeam {
  double length = 0;             ///< [m]
  double flexural_rigidity = 0;  ///< EI [N m^2]
  double mass_per_length = 0;    ///< rho_bar [kg/m]

  /// c = sqrt(EI / rho_bar) [m^2/s], as used in (5.72).
  double dispersion() const;
};

/// Section of a uniform beam, for the finite elements.
Section section_of(const UniformBeam& beam);

}  // namespace zona::beam
