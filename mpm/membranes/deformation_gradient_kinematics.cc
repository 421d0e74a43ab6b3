#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mpm/membranes/membrane_kinematics.h"

namespace zona::mpm {

namespace {

using TangentBasis = Eigen::Matrix<double, 3, 2>;

Eigen::Vector3d reference_normal(const Triangle& t, const std::vector<Eigen::Vector3d>& places) {
  return (places[t[1]] - places[t[0]]).cross(places[t[2]] - places[t[0]]).normalized();
}

/// The vertices of a triangle other than `point`, in its order.
std::array<int, 2> other_vertices(const Triangle& t, int point) {
  const int v = t[0] == point ? 0 : t[1] == point ? 1 : 2;
  return {t[(v + 1) % 3], t[(v + 2) % 3]};
}

/// Smallest rotation from one unit vector to another that is not its opposite. Eigen's
/// FromTwoVectors does the same, but compiles a singular value decomposition for opposite vectors.
Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized();
  const Eigen::Vector3d b = to.normalized();
  const double twice_cosine = std::sqrt((1 + b.dot(a)) * 2);
  Eigen::Quaterniond rotation;
  rotation.vec() = a.cross(b) * (1 / twice_cosine);
  rotation.w() = twice_cosine * 0.5;
  return rotation;
}

TangentBasis tangent_basis(const Eigen::Vector3d& normal) {
  TangentBasis basis;
  basis.col(0) = normal.unitOrthogonal();
  basis.col(1) = normal.cross(basis.col(0));
  return basis;
}

}  // namespace

DeformationGradientKinematics::DeformationGradientKinematics(const MaterialPoints& points,
                                                             const Surface& surface) {
  const int count = points.size();
  for (int p = 0; p < count; ++p) reference_.push_back(points.position_of(p));
  first_neighbour_.push_back(0);
  for (int p = 0; p < count; ++p) {
    std::vector<int> others;
    for (const int* t = surface.triangles_begin(p); t != surface.triangles_end(p); ++t) {
      for (int v : other_vertices(surface.triangles()[*t], p)) others.push_back(v);
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    neighbour_.insert(neighbour_.end(), others.begin(), others.end());
    first_neighbour_.push_back(static_cast<int>(neighbour_.size()));
  }
  weight_.resize(neighbour_.size());
  for (int p = 0; p < count; ++p) build_weights(p, surface);
  for (auto& component : gradient_) component.assign(count, 0.0);
}

Eigen::Vector3d DeformationGradientKinematics::point_normal(int point,
                                                            const Surface& surface) const {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const int* t = surface.triangles_begin(point); t != surface.triangles_end(point); ++t) {
    normal += reference_normal(surface.triangles()[*t], reference_);
  }
  normal.normalize();
  return normal;
}

void DeformationGradientKinematics::build_weights(int point, const Surface& surface) {
  const int begin = first_neighbour_[point];
  const int end = first_neighbour_[point + 1];
  std::fill(weight_.begin() + begin, weight_.begin() + end, std::array<double, 2>{});
  const Eigen::Vector3d normal = point_normal(point, surface);
  const TangentBasis basis = tangent_basis(normal);

  double total_area = 0;
  TangentBasis reference_gradient = TangentBasis::Zero();
  const auto add = [&](int vertex, const Eigen::Vector2d& weight) {
    const auto n = std::lower_bound(neighbour_.begin() + begin, neighbour_.begin() + end, vertex);
    auto& sum = weight_[n - neighbour_.begin()];
    for (int c = 0; c < 2; ++c) sum[c] += weight[c];
    reference_gradient += (reference_[vertex] - reference_[point]) * weight.transpose();
  };
  for (const int* t = surface.triangles_begin(point); t != surface.triangles_end(point); ++t) {
    if (!surface.intact(*t)) continue;
    const Triangle& triangle = surface.triangles()[*t];
    const auto [b, c] = other_vertices(triangle, point);
    // Rotate the triangle into the point's tangent plane about their common line.
    const Eigen::Quaterniond rotation =
        rotation_between(reference_normal(triangle, reference_), normal);
    Eigen::Matrix2d edges;
    edges.col(0) = basis.transpose() * (rotation * (reference_[b] - reference_[point]));
    edges.col(1) = basis.transpose() * (rotation * (reference_[c] - reference_[point]));
    const double area = 0.5 * edges.determinant();
    const Eigen::Matrix2d inverse = area * edges.inverse();
    total_area += area;
    add(b, inverse.row(0));
    add(c, inverse.row(1));
  }
  if (!(total_area > 0)) return;
  // The mean over triangles in different planes is not quite an isometry. Correct it, so that the
  // undeformed surface has no strain.
  reference_gradient /= total_area;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> stretch(reference_gradient.transpose() *
                                                               reference_gradient);
  const Eigen::Matrix2d correction = stretch.operatorInverseSqrt() / total_area;
  for (int n = begin; n < end; ++n) {
    const Eigen::Vector2d w = correction * Eigen::Vector2d(weight_[n][0], weight_[n][1]);
    weight_[n] = {w[0], w[1]};
  }
}

void DeformationGradientKinematics::follow(const PointGroup& group, const std::array<Field, 3>& x,
                                           const Surface&) {
  std::array<Lanes, 6> f{};
  for (int l = 0; l < group.count(); ++l) {
    const int p = group[l];
    for (int n = first_neighbour_[p]; n < first_neighbour_[p + 1]; ++n) {
      for (int c = 0; c < 3; ++c) {
        const double edge = x[c][neighbour_[n]] - x[c][p];
        f[c][l] += edge * weight_[n][0];
        f[3 + c][l] += edge * weight_[n][1];
      }
    }
  }
  group.store(gradient_, f);
}

LocalStrain DeformationGradientKinematics::local_strain(const PointGroup& group) const {
  const VectorLanes f1{group.load(gradient_[0]), group.load(gradient_[1]),
                       group.load(gradient_[2])};
  const VectorLanes f2{group.load(gradient_[3]), group.load(gradient_[4]),
                       group.load(gradient_[5])};
  const Lanes c11 = dot(f1, f1);
  const Lanes c22 = dot(f2, f2);
  const Lanes c12 = dot(f1, f2);
  // Square root of the 2 x 2 tensor C (Cayley-Hamilton). A point without triangles has F = 0 and
  // gets no strain.
  const Lanes det = square_root(larger(c11 * c22 - c12 * c12, Lanes{}));
  const Lanes scale = 1.0 / square_root(larger(c11 + c22 + 2.0 * det, broadcast(1e-30)));
  const LaneMask has_triangles = c11 + c22 > 0.0;
  const Lanes u11 = select(has_triangles, (c11 + det) * scale, broadcast(1));
  const Lanes u22 = select(has_triangles, (c22 + det) * scale, broadcast(1));
  const Lanes u12 = c12 * scale;
  const Lanes inverse = 1.0 / larger(u11 * u22 - u12 * u12, broadcast(1e-30));
  VectorLanes x;
  VectorLanes y;
  for (int i = 0; i < 3; ++i) {
    x[i] = (f1[i] * u22 - f2[i] * u12) * inverse;
    y[i] = (f2[i] * u11 - f1[i] * u12) * inverse;
  }
  return {{u11 - 1.0, u22 - 1.0, u12}, x, y};
}

void DeformationGradientKinematics::forget_failed(int, const std::vector<int>& neighbours,
                                                  const Surface& surface) {
  for (int p : neighbours) build_weights(p, surface);
}

}  // namespace zona::mpm
