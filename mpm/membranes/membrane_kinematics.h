#pragma once

#include <variant>

#include "mpm/membranes/membrane_law.h"
#include "mpm/membranes/surface.h"
#include "mpm/points/velocity_gradient.h"

namespace zona::mpm {

/// In-plane strain of eight membrane points and the current directions of its axes in space.
struct LocalStrain {
  InPlane strain;  ///< [-]
  VectorLanes x;   ///< local x' (unit vector)
  VectorLanes y;   ///< local y'
};

/// Kinematics of the source (4.4)-(4.21): sums the strain from the grid in the fixed axes and
/// transforms it to a local frame, which the rotation S between successive point normals updates.
/// Not objective: an out-of-plane slope s appears as a tangential strain s^2/(1 + s^2).
class SummedStrainKinematics {
 public:
  /// Zero strain, with the local frames of the undeformed surface.
  SummedStrainKinematics(const MaterialPoints& points, Surface& surface);

  /// Adds a step's strain increments (4.4).
  void accumulate(const PointGroup& group, const VelocityGradient& gradient, double dt);
  /// Must be called before `follow`, with the same positions.
  void prepare(const std::array<Field, 3>& position, Surface& surface, int threads) const {
    surface.compute_normals(position, threads);
  }
  /// Rotates the local frames of eight consecutive points, starting at a multiple of eight, to the
  /// normals at these positions [m] (4.12)-(4.21).
  void follow(const PointGroup& group, const std::array<Field, 3>& position,
              const Surface& surface);
  /// Total strain in the local frame (4.10).
  LocalStrain local_strain(const PointGroup& group) const;
  /// Does nothing: strains do not depend on neighbours.
  void forget_failed(int, const std::vector<int>&, const Surface&) {}
  /// Calls f(Field) for each field that a step changes.
  template <class F>
  void for_each_field(F f) {
    for (auto& c : total_strain_) f(c);
    for (auto& c : normal_) f(c);
    for (auto& c : tangent_) f(c);
  }

 private:
  SymmetricTensorField total_strain_;  ///< in the fixed axes [-]
  std::array<Field, 3> normal_;        ///< z'
  std::array<Field, 3> tangent_;       ///< x'
};

/// Objective kinematics: the area-weighted deformation gradient of the intact triangles around a
/// point, and the Biot strain U - I, whose principal values are the stretches minus one, the
/// measure of (5.56). Rigid motions give exactly zero strain.
class DeformationGradientKinematics {
 public:
  /// The current positions of the points are the undeformed ones.
  DeformationGradientKinematics(const MaterialPoints& points, const Surface& surface);

  void accumulate(const PointGroup&, const VelocityGradient&, double) {}  ///< does nothing
  void prepare(const std::array<Field, 3>&, Surface&, int) const {}       ///< does nothing
  /// Computes the deformation gradients of a group at these positions [m].
  void follow(const PointGroup& group, const std::array<Field, 3>& position, const Surface&);
  /// Biot strain U - I of F = R U; its axes are the columns of R.
  LocalStrain local_strain(const PointGroup& group) const;
  /// Rebuilds the weights of `neighbours` from the intact triangles.
  void forget_failed(int point, const std::vector<int>& neighbours, const Surface& surface);
  /// No fields: everything follows from the positions and the intact triangles.
  template <class F>
  void for_each_field(F) {}

 private:
  /// Unit normal of the undeformed surface at a point.
  Eigen::Vector3d point_normal(int point, const Surface& surface) const;
  void build_weights(int point, const Surface& surface);

  std::vector<Eigen::Vector3d> reference_;  ///< initial positions [m]
  std::vector<int> first_neighbour_;        ///< start of each point's entries in neighbour_
  std::vector<int> neighbour_;
  /// F = sum over neighbours (x_n - x_p) (x) weight [1/m].
  std::vector<std::array<double, 2>> weight_;
  std::array<Field, 6> gradient_;  ///< F, columns x' and y': 3 + 3 components [-]
};

/// Either kinematics.
using MembraneKinematics = std::variant<SummedStrainKinematics, DeformationGradientKinematics>;

}  // namespace zona::mpm
