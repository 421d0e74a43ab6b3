#include <Eigen/Geometry>

#include "mpm/membranes/membrane_kinematics.h"

namespace zona::mpm {

SummedStrainKinematics::SummedStrainKinematics(const MaterialPoints& points, Surface& surface) {
  const int count = points.size();
  for (auto& component : total_strain_) component.assign(count, 0.0);
  for (auto* vectors : {&normal_, &tangent_}) {
    for (auto& component : *vectors) component.assign(count, 0.0);
  }
  surface.compute_normals(points.position, 1);
  for (int first = 0; first < count; first += lane_count) {
    const VectorLanes sum = surface.normal_sum(first);
    consecutive(first, count).store(normal_, scaled(sum, 1.0 / square_root(dot(sum, sum))));
  }
  for (int p = 0; p < count; ++p) {
    const Eigen::Vector3d tangent =
        Eigen::Vector3d(normal_[0][p], normal_[1][p], normal_[2][p]).unitOrthogonal();
    for (int c = 0; c < 3; ++c) tangent_[c][p] = tangent[c];
  }
}

void SummedStrainKinematics::accumulate(const PointGroup& group, const VelocityGradient& gradient,
                                        double dt) {
  const SymmetricTensorLanes rate = strain_rate(gradient);
  for (int c = 0; c < 6; ++c)
    group.store(total_strain_[c], group.load(total_strain_[c]) + dt * rate[c]);
}

void SummedStrainKinematics::follow(const PointGroup& group, const std::array<Field, 3>&,
                                    const Surface& surface) {
  const VectorLanes sum = surface.normal_sum(group[0]);
  const VectorLanes old_z = group.load(normal_);
  const VectorLanes x = group.load(tangent_);
  const Lanes length = square_root(dot(sum, sum));
  VectorLanes z;
  for (int i = 0; i < 3; ++i) z[i] = select(length > 0.0, sum[i] / length, old_z[i]);
  // S x' of (4.21) for x' normal to z'_k. With w = z'_k x z'_{k+1} and c = z'_k . z'_{k+1},
  // S x' = c x' + w (w . x')/(1 + c) - z'_k (z'_{k+1} . x').
  const VectorLanes w = cross(old_z, z);
  const Lanes c = dot(old_z, z);
  const Lanes along = dot(w, x) / (1.0 + c);
  const Lanes back = dot(z, x);
  VectorLanes turned;
  for (int i = 0; i < 3; ++i) turned[i] = c * x[i] + along * w[i] - back * old_z[i];
  // Orthonormalise, so that rounding errors do not accumulate over 1e5 steps.
  const Lanes off = dot(turned, z);
  for (int i = 0; i < 3; ++i) turned[i] -= off * z[i];
  group.store(tangent_, scaled(turned, 1.0 / square_root(dot(turned, turned))));
  group.store(normal_, z);
}

LocalStrain SummedStrainKinematics::local_strain(const PointGroup& group) const {
  const SymmetricTensorLanes e = group.load(total_strain_);
  const VectorLanes x = group.load(tangent_);
  const VectorLanes y = cross(group.load(normal_), x);
  const auto times = [&e](const VectorLanes& v) -> VectorLanes {
    return {e[0] * v[0] + e[3] * v[1] + e[5] * v[2], e[3] * v[0] + e[1] * v[1] + e[4] * v[2],
            e[5] * v[0] + e[4] * v[1] + e[2] * v[2]};
  };
  const VectorLanes ex = times(x);
  return {{dot(x, ex), dot(y, times(y)), dot(y, ex)}, x, y};
}

}  // namespace zona::mpm
