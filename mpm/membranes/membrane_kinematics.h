#pragma once

#include <variant>

#include "mpm/membranes/membrane_law.h"
#include "mpm/membranes/surface.h"
#include "mpm/points/velocity_gradient.h"

namespace zona::mpm {

/// In-plane strain of eight membrane points and the directions in space that its axes have now.
struct LocalStrain {
  InPlane strain;  ///< [-]
  VectorLanes x;   ///< local x' (unit vector)
  VectorLanes y;   ///< local y'
};

/// Kinematics of the source (4.4)-(4.21): the strain from the grid is summed in the fixed axes and
/// seen in a local frame that the rotation S between successive point normals carries along. Not
/// objective: an out-of-plane slope s appears as a tangential strain s^2/(1 + s^2).
class SummedStrainKinematics {
 public:
  /// No strain yet; the local frames are those of the undeformed surface.
  SummedStrainKinematics(const MaterialPoints& points, Surface& surface);

  /// Adds a step's strain increments (4.4).
  void accumulate(const PointGroup& group, const VelocityGradient& gradient, double dt);
  /// To be called before the points follow to the given positions.
  void prepare(const std::array<Field, 3>& position, Surface& surface, int threads) const {
    surface.find_normals(position, threads);
  }
  /// Turns the local frames of eight consecutive points, from a multiple of eight on, to the
  /// normals of the given positions (4.12)-(4.21).
  void follow(const PointGroup& group, const std::array<Field, 3>& position,
              const Surface& surface);
  /// The total strain in the local frame (4.10).
  LocalStrain local_strain(const PointGroup& group) const;
  /// Nothing to forget: strains are those of the points.
  void forget_failed(int, const std::vector<int>&, const Surface&) {}
  /// Calls f(Field) for what steps change.
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

/// Objective kinematics: the deformation gradient of the intact triangles around a point (area
/// weighted), and the Biot strain U - I, whose principal values are the stretches less one, the
/// measure of (5.56). Rigid motions give exactly no strain.
class DeformationGradientKinematics {
 public:
  /// The points' places are the undeformed ones.
  DeformationGradientKinematics(const MaterialPoints& points, const Surface& surface);

  void accumulate(const PointGroup&, const VelocityGradient&, double) {}  ///< nothing: see `follow`
  void prepare(const std::array<Field, 3>&, Surface&, int) const {}       ///< nothing
  /// Deformation gradients of a group at these positions [m].
  void follow(const PointGroup& group, const std::array<Field, 3>& position, const Surface&);
  /// The Biot strain U - I of F = R U; its axes are the columns of R.
  LocalStrain local_strain(const PointGroup& group) const;
  /// Rebuilds the gradients of `neighbours` from the triangles that are still intact.
  void forget_failed(int point, const std::vector<int>& neighbours, const Surface& surface);
  /// State that changes: none, everything follows from the positions and the intact triangles.
  template <class F>
  void for_each_field(F) {}

 private:
  void build_weights(int point, const Surface& surface);

  std::vector<Eigen::Vector3d> reference_;  ///< initial positions [m]
  std::vector<int> first_neighbour_;        ///< where each point's neighbours start
  std::vector<int> neighbour_;
  std::vector<std::array<double, 2>>
      weight_;                     ///< F = sum over neighbours (x_n - x_p) (x) weight [1/m]
  std::array<Field, 6> gradient_;  ///< F, columns x' and y': 3 + 3 components [-]
};

/// Either kinematics.
using MembraneKinematics = std::variant<SummedStrainKinematics, DeformationGradientKinematics>;

}  // namespace zona::mpm
