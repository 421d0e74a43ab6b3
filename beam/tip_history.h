#pragma once

#include <vector>

namespace zona::beam {

/// Lateral motion of the pipette's tip and of its support, sampled at strictly increasing times.
/// All vectors have the same length; displacements are absolute (fixed frame), so the deflection
/// relative to the moving support is `displacement - support`.
struct TipHistory {
  std::vector<double> time;          ///< [s]
  std::vector<double> displacement;  ///< absolute tip displacement [m]
  std::vector<double> velocity;      ///< absolute tip velocity [m/s]
  std::vector<double> acceleration;  ///< absolute tip acceleration [m/s^2]
  std::vector<double> support;       ///< displacement g(t) of the clamped support [m]
};

}  // namespace zona::beam
