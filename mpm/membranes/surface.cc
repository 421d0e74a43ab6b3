#include "mpm/membranes/surface.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <utility>

#include "mpm/points/errors.h"

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
      first_around_(places.size() + 1, 0),
      around_(3 * triangles_.size()) {
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
  pad_to_lanes();
}

void Surface::pad_to_lanes() {
  const auto padded = [](std::size_t n) { return (n + lane_count - 1) / lane_count * lane_count; };
  const std::size_t triangles = padded(triangles_.size() + 1);
  for (int corner = 0; corner < 3; ++corner) {
    vertex_[corner].assign(triangles, 0);  // padding has no area and hence no normal
    for (std::size_t t = 0; t < triangles_.size(); ++t) vertex_[corner][t] = triangles_[t][corner];
  }
  for (auto& component : normal_) component.assign(triangles, 0.0);
  intact_.assign(triangles, 0.0);
  std::fill_n(intact_.begin(), triangles_.size(), 1.0);
  const std::size_t points = first_around_.size() - 1;
  int most = 0;
  for (std::size_t p = 0; p < points; ++p)
    most = std::max(most, first_around_[p + 1] - first_around_[p]);
  const int none = static_cast<int>(triangles) - 1;
  column_.assign(most, std::vector<int>(padded(points), none));
  for (std::size_t p = 0; p < points; ++p) {
    for (int k = 0; k < first_around_[p + 1] - first_around_[p]; ++k)
      column_[k][p] = around_[first_around_[p] + k];
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

void Surface::compute_normals(const std::array<Field, 3>& position, int threads) {
  const int count = static_cast<int>(vertex_[0].size());
#pragma omp parallel for num_threads(threads) schedule(static)
  for (int first = 0; first < count; first += lane_count) {
    VectorLanes corner[3];
    for (int v = 0; v < 3; ++v) {
      for (int c = 0; c < 3; ++c) corner[v][c] = gather(position[c].data(), &vertex_[v][first]);
    }
    VectorLanes u, w;
    for (int c = 0; c < 3; ++c) {
      u[c] = corner[1][c] - corner[0][c];
      w[c] = corner[2][c] - corner[0][c];
    }
    const VectorLanes n = cross(u, w);
    const Lanes scale = load(&intact_[first]) / larger(square_root(dot(n, n)), broadcast(1e-300));
    for (int c = 0; c < 3; ++c) store(&normal_[c][first], n[c] * scale);
  }
}

VectorLanes Surface::normal_sum(int first) const {
  VectorLanes sum{};
  for (const auto& column : column_) {
    for (int c = 0; c < 3; ++c) sum[c] += gather(normal_[c].data(), &column[first]);
  }
  return sum;
}

}  // namespace zona::mpm
