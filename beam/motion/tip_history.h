#pragma once

#include <cstddef>
#include <vector>

namespace zona::beam {

/// Motion of the pipette's tip and support, across or along the pipette, sampled at strictly
/// increasing times. All vectors have the same length. Displacements are absolute (fixed frame):
/// the deflection relative to the support is `displacement - support`.
struct TipHistory {
  std::vector<double> time;          ///< [s]
  std::vector<double> displacement;  ///< absolute tip displacement [m]
  std::vector<double> velocity;      ///< absolute tip velocity [m/s]
  std::vector<double> acceleration;  ///< absolute tip acceleration [m/s^2]
  std::vector<double> support;       ///< displacement g(t) of the clamped support [m]
};

/// Index of the value with the greatest magnitude, the first of equal ones. `values` must not be
/// empty.
std::size_t index_of_peak(const std::vector<double>& values);

/// Dimensionless amplitude of Figure 5.28: greatest |absolute tip displacement| of the samples over
/// the peak displacement of the support [m]. Throws std::invalid_argument if that peak is zero or
/// not finite, or if there are no samples.
double amplitude_ratio(const TipHistory& history, double support_peak);

}  // namespace zona::beam
