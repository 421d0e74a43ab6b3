#include "studies/kinds/search/pareto.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace zona::studies::search {

namespace {

using Point = std::vector<double>;

bool dominates(const Point& a, const Point& b) {
  bool is_less = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] > b[k]) return false;
    is_less = is_less || a[k] < b[k];
  }
  return is_less;
}

/// Those of the numbered points that no other of them dominates. Sorted by their coordinates, a
/// point is dominated by a later one never, so it is enough to compare with the front so far.
std::vector<std::size_t> front_of(const std::vector<Point>& points,
                                  std::vector<std::size_t> numbers) {
  std::sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  });
  std::vector<std::size_t> front;
  for (const std::size_t number : numbers) {
    const bool is_dominated = std::any_of(front.begin(), front.end(), [&](std::size_t other) {
      return dominates(points[other], points[number]);
    });
    if (!is_dominated) front.push_back(number);
  }
  std::sort(front.begin(), front.end());
  return front;
}

std::vector<std::size_t> numbers_up_to(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order = numbers_up_to(values.size());
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> rank(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last + 1 < order.size() && values[order[last + 1]] == values[order[first]]) ++last;
    for (std::size_t i = first; i <= last; ++i)
      rank[order[i]] = 0.5 * static_cast<double>(first + last);
    first = last + 1;
  }
  return rank;
}

}  // namespace

std::vector<int> pareto_levels(const std::vector<Point>& points) {
  std::vector<int> levels(points.size(), -1);
  std::vector<std::size_t> left = numbers_up_to(points.size());
  for (int level = 0; !left.empty(); ++level) {
    for (const std::size_t number : front_of(points, left)) levels[number] = level;
    left.erase(std::remove_if(left.begin(), left.end(),
                              [&](std::size_t number) { return levels[number] >= 0; }),
               left.end());
  }
  return levels;
}

std::vector<std::size_t> pareto_front(const std::vector<Point>& points) {
  return front_of(points, numbers_up_to(points.size()));
}

std::vector<std::size_t> spread(const std::vector<Point>& points, std::size_t count) {
  if (points.empty() || count == 0) return {};
  Point low = points.front(), high = points.front();
  for (const Point& point : points)
    for (std::size_t k = 0; k < point.size(); ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  const auto distance = [&](const Point& a, const Point& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
      if (high[k] > low[k]) sum += std::pow((a[k] - b[k]) / (high[k] - low[k]), 2);
    return sum;
  };
  const auto first = std::min_element(points.begin(), points.end());
  std::vector<std::size_t> chosen{static_cast<std::size_t>(first - points.begin())};
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  while (chosen.size() < std::min(count, points.size())) {
    for (std::size_t i = 0; i < points.size(); ++i)
      nearest[i] = std::min(nearest[i], distance(points[i], points[chosen.back()]));
    const auto farthest = std::max_element(nearest.begin(), nearest.end());
    if (*farthest == 0) break;
    chosen.push_back(static_cast<std::size_t>(farthest - nearest.begin()));
  }
  return chosen;
}

std::vector<std::vector<double>> simplex_lattice(std::size_t objectives, int divisions) {
  std::vector<std::vector<double>> lattice;
  std::vector<double> weights(objectives);
  const std::function<void(std::size_t, int)> fill = [&](std::size_t k, int left) {
    if (k + 1 == objectives) {
      weights[k] = static_cast<double>(left) / divisions;
      lattice.push_back(weights);
      return;
    }
    for (int part = left; part >= 0; --part) {
      weights[k] = static_cast<double>(part) / divisions;
      fill(k + 1, left - part);
    }
  };
  fill(0, divisions);
  return lattice;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= values.size()) return values.back();
  const double part = place - static_cast<double>(below);
  return (1 - part) * values[below] + part * values[below + 1];
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> x = ranks(a), y = ranks(b);
  const double mean = 0.5 * static_cast<double>(x.size() - 1);
  double xy = 0, xx = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean) * (y[i] - mean);
    xx += (x[i] - mean) * (x[i] - mean);
    yy += (y[i] - mean) * (y[i] - mean);
  }
  return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : 0;
}

}  // namespace zona::studies::search
