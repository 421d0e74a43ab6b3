#pragma once

#include <cstddef>
#include <vector>

namespace zona::studies::search {

/// Number of fronts before that of each point: 0 on the Pareto front, 1 on the front of the rest,
/// and so on (Deb et al. 2002). All coordinates are minimised: a point dominates another when
/// none of its coordinates is greater and one is less.
std::vector<int> pareto_levels(const std::vector<std::vector<double>>& points);

/// Numbers of the points of the Pareto front.
std::vector<std::size_t> pareto_front(const std::vector<std::vector<double>>& points);

/// Up to `count` points that lie far apart: the least in the first coordinate, then each time the
/// one farthest from all chosen before. Distances are relative to the ranges of the coordinates.
std::vector<std::size_t> spread(const std::vector<std::vector<double>>& points, std::size_t count);

/// Weightings of the objectives, each with the sum one, evenly over the simplex in steps of
/// 1/`divisions` (Das and Dennis 1998).
std::vector<std::vector<double>> simplex_lattice(std::size_t objectives, int divisions);

/// The quantile of the values at a share from 0 to 1, linear between them; needs one value at
/// least.
double quantile(std::vector<double> values, double share);

/// Spearman's rank correlation of pairs, ties with their mean rank; 0 where either is constant.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace zona::studies::search
