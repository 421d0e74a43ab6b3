#pragma once

#include <cstddef>
#include <vector>

namespace zona::studies::search {

/// Of each point how many fronts lie before its own: 0 on the Pareto front, 1 on the front of what
/// is left without that, and so on (Deb et al. 2002). One point dominates another that is nowhere
/// less and somewhere more; all coordinates are to be small.
std::vector<int> pareto_levels(const std::vector<std::vector<double>>& points);

/// Numbers of the points of the Pareto front.
std::vector<std::size_t> pareto_front(const std::vector<std::vector<double>>& points);

/// Up to `count` of the points, spread out: the least in the first coordinate, then each time the
/// one farthest from all before, where every coordinate counts by its range over the points.
std::vector<std::size_t> spread(const std::vector<std::vector<double>>& points, std::size_t count);

/// Weights of so many objectives that sum to one, evenly over the simplex, in steps of
/// 1/`divisions` (Das and Dennis 1998).
std::vector<std::vector<double>> simplex_lattice(std::size_t objectives, int divisions);

/// The value below which that share of the values lies, linear between them; they must not be
/// empty.
double quantile(std::vector<double> values, double share);

/// Spearman's rank correlation of pairs, ties with their mean rank; 0 where either is constant.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace zona::studies::search
