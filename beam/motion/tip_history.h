#pragma once

#include <cstddef>
#include <vector>

namespace zona::beam {

/// Motion of the pipette's tip and of its support, across the pipette or along it, sampled at
/// strictly increasing times. All vectors have the same length; displacements are absolute (fixed
/// frame), so the deflection relative to the moving support is `displacement - support`.
struct TipHistory {
  std::vector<double> time;          ///< [s]
  std::vector<double> displacement;  ///< absolute tip displacement [m]
  std::vector<double> velocity;      ///< absolute tip velocity [m/s]
  std::vector<double> acceleration;  ///< absolute tip acceleration [m/s^2]
  std::vector<double> support;       ///< displacement g(t) of the clamped support [m]
};

/// Deflection of the tip relative to the support, sample by sample [m].
std::vector<double> relative_displacement(const TipHistory& history);

/// Index of the value of greatest magnitude, the first of equals. The values must not be empty.
std::size_t index_of_peak(const std::vector<double>& values);

/// Dimensionless amplitude of Figure 5.28: greatest |absolute tip displacement| of the samples over
/// the peak displacement of the support [m]. Throws std::invalid_argument if that peak is zero or
/// there are no samples.
double amplitude_ratio(const TipHistory& history, double support_peak);

}  // namespace zona::beam
