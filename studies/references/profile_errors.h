#pragma once

#include <functional>
#include <vector>

namespace zona::studies::references {

/// Errors of a sampled profile: averages weighted by the samples' lengths, so that profiles of
/// different length and sampling can be compared.
struct ProfileErrors {
  double l1 = 0;       ///< mean of |computed - exact|
  double l2 = 0;       ///< root of the mean square
  double largest = 0;  ///< largest magnitude
};

/// A computed profile: the value of a quantity at x, standing for a length (a cell, a share of
/// one).
struct Sample {
  double x;           ///< [m]
  double value;       ///< in the quantity's unit
  double length = 1;  ///< weight [m]; any common factor drops out
};

/// Errors against `exact` at the samples' own places. Throws ModelError without samples, or for a
/// length that is not positive.
ProfileErrors profile_errors(const std::vector<Sample>& samples,
                             const std::function<double(double x)>& exact);

/// Observed order of convergence: the slope of the least-squares line through log(error) against
/// log(h). Throws ModelError unless there are two or more pairs, all positive, with different h.
double observed_order(const std::vector<double>& h, const std::vector<double>& error);

/// Value towards which a sequence converges from its last two members, whose spacings are
/// h_coarse > h_fine, at a known order (Richardson).
double extrapolated(double h_coarse, double coarse, double h_fine, double fine, double order);

}  // namespace zona::studies::references
