#include "mpm/surface.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <utility>

#include "mpm/errors.h"

namespace zona::mpm {

namespace {

Eigen::Vector3d at(const std::array<Field, 3>& position, int p) {
  return {position[0][p], position[1][p], position[2][p]};
}

Eigen::Vector3d area_vector(const std::array<Field, 3>& position, const Triangle& t) {
  const Eigen::Vector3d a = at(position, t[0]);
  return 0.5 * (at(position, t[1]) - a).cross(at(position, t[2]) - a);
}

}  // namespace

Surface::Surface(std::vector<Triangle> triangles, const std::vector<Eigen::Vector3d>& places)
    : triangles_(std::move(triangles)),
      intact_(triangles_.size(), 1),
      first_around_(places.size() + 1, 0),
      around_(3 * triangles_.size()),
      triangle_normal_(triangles_.size()) {
  const int count = static_cast<int>(places.size());
  for (const auto& t : triangles_) {
    for (int v : t) {
      if (v < 0 || v >= count)
        throw ModelError(fmt::format("a triangle names vertex {} of {}", v, count));
      ++first_around_[v + 1];
    }
    const Eigen::Vector3d normal = (places[t[1]] - places[t[0]]).cross(places[t[2]] - places[t[0]]);
    if (!(normal.norm() > 0)) {
      throw ModelError(
          fmt::format("the triangle of vertices {}, {}, {} has no area", t[0], t[1], t[2]));
    }
  }
  for (int p = 0; p < count; ++p) {
    if (first_around_[p + 1] == 0)
      throw ModelError(fmt::format("membrane point {} is in no triangle", p));
  }
  std::partial_sum(first_around_.begin(), first_around_.end(), first_around_.begin());
  std::vector<int> next(first_around_.begin(), first_around_.end() - 1);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (int v : triangles_[t]) around_[next[v]++] = static_cast<int>(t);
  }
}

std::vector<double> Surface::areas(const std::array<Field, 3>& position) const {
  std::vector<double> areas(first_around_.size() - 1, 0.0);
  for (const auto& t : triangles_) {
    const double third = area_vector(position, t).norm() / 3;
    for (int v : t) areas[v] += third;
  }
  return areas;
}

std::vector<int> Surface::drop_triangles_of(int point) {
  std::vector<int> others;
  for (const int* t = triangles_begin(point); t != triangles_end(point); ++t) {
    intact_[*t] = 0;
    for (int v : triangles_[*t]) {
      if (v != point) others.push_back(v);
    }
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  return others;
}

void Surface::point_normals(const std::array<Field, 3>& position, std::array<Field, 3>& normal,
                            int threads) {
  const int triangle_count = static_cast<int>(triangles_.size());
  const int point_count = static_cast<int>(first_around_.size()) - 1;
#pragma omp parallel num_threads(threads)
  {
#pragma omp for schedule(static)
    for (int t = 0; t < triangle_count; ++t) {
      const Eigen::Vector3d n = area_vector(position, triangles_[t]);
      const double scale = intact_[t] ? 1 / std::max(n.norm(), 1e-300) : 0.0;
      triangle_normal_[t] = {n.x() * scale, n.y() * scale, n.z() * scale};
    }
#pragma omp for schedule(static)
    for (int p = 0; p < point_count; ++p) {
      double sum[3] = {0, 0, 0};
      for (const int* t = triangles_begin(p); t != triangles_end(p); ++t) {
        for (int c = 0; c < 3; ++c) sum[c] += triangle_normal_[*t][c];
      }
      const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
      if (length > 0) {
        for (int c = 0; c < 3; ++c) normal[c][p] = sum[c] / length;
      }
    }
  }
}

}  // namespace zona::mpm
