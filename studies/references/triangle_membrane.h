#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "studies/references/membrane_law.h"

namespace zona::studies::references {

/// Strain measure of a triangle.
enum class TriangleStrain {
  stretches,  ///< principal stretches of the deformation gradient, in the law's measure: objective
  summed      ///< increments sym(grad u) summed in fixed axes and seen in the local frame that the
              ///< normal carries along: (4.4)-(4.21), which double the strain of small slopes
};

/// Constant-strain triangles of a membrane that is flat, at z = 0, and unstressed at first.
/// Positions belong to the caller; a triangle keeps its reference state and its summed strain.
class TriangleMembrane {
 public:
  using Positions = std::vector<Eigen::Vector3d>;

  /// Throws ModelError for a triangle without area or one that is seen clockwise from above.
  TriangleMembrane(const MembraneLaw& law, TriangleStrain strain, const Positions& reference,
                   std::vector<std::array<int, 3>> triangles);

  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
  /// Mass [kg] of every node: a third of each triangle around it.
  std::vector<double> nodal_mass(double density) const;
  /// Internal forces [N] at `position`, added to `force`; `before` are the positions of the last
  /// call. Adds the work done on the membrane to its energy.
  void add_forces(const Positions& before, const Positions& position, Positions& force);
  /// Work done on the membrane so far [J]; the stored energy, if the law has one.
  double energy() const { return energy_; }
  double largest_strain() const;  ///< largest principal one

 private:
  struct Triangle {
    double area;                                       ///< undeformed [m^2]
    Eigen::Matrix2d inverse;                           ///< of the undeformed edges [1/m]
    Eigen::Matrix3d strain = Eigen::Matrix3d::Zero();  ///< summed, fixed axes
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();
    Eigen::Matrix3d force = Eigen::Matrix3d::Zero();  ///< of the last call, a column a node
    double largest_strain = 0;
  };
  using Edges = Eigen::Matrix<double, 3, 2>;

  Eigen::Matrix3d tension_of_stretches(Triangle& triangle, const Edges& gradient) const;
  Eigen::Matrix3d tension_of_sum(Triangle& triangle, const Edges& edges, const Edges& change) const;

  MembraneLaw law_;
  TriangleStrain strain_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<Triangle> state_;
  double energy_ = 0;
};

/// Nodes and triangles of the square [0, side]^2 in n x n squares, each cut in two along diagonals
/// that alternate, so that the mesh is the same seen along x and y. Node (i, j) is i + (n + 1) j.
struct SquareMesh {
  std::vector<Eigen::Vector3d> nodes;
  std::vector<std::array<int, 3>> triangles;
};
SquareMesh square_mesh(double side, int n);

}  // namespace zona::studies::references
