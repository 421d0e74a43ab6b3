#include "studies/references/triangle_membrane.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "studies/references/require.h"

namespace zona::studies::references {

namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Edges = Eigen::Matrix<double, 3, 2>;

Edges edges_of(const std::array<int, 3>& t, const TriangleMembrane::Positions& x) {
  Edges e;
  e.col(0) = x[t[1]] - x[t[0]];
  e.col(1) = x[t[2]] - x[t[0]];
  return e;
}

struct Eigen2 {
  double first, second;  ///< values, first >= second
  Vector2d axis;         ///< of the first
};

Eigen2 principal(const Matrix2d& a) {
  const double mean = 0.5 * (a(0, 0) + a(1, 1)), half = 0.5 * (a(0, 0) - a(1, 1));
  const double radius = std::hypot(half, a(0, 1));
  const double angle = radius > 0 ? 0.5 * std::atan2(a(0, 1), half) : 0;
  return {mean + radius, mean - radius, {std::cos(angle), std::sin(angle)}};
}

/// Gradients in the surface of the functions that are 1 at nodes 1 and 2: dual to the edges.
Edges surface_gradients(const Edges& edges) {
  return edges * (edges.transpose() * edges).inverse();
}

/// S x' of (4.21) for a tangent x' of the plane with the normal `from`.
Vector3d carried(const Vector3d& tangent, const Vector3d& from, const Vector3d& to) {
  const Vector3d w = from.cross(to);
  const double c = from.dot(to);
  return c * tangent + w.dot(tangent) / (1 + c) * w - to.dot(tangent) * from;
}

}  // namespace

TriangleMembrane::TriangleMembrane(const MembraneLaw& law, TriangleStrain strain,
                                   const Positions& reference,
                                   std::vector<std::array<int, 3>> triangles)
    : law_(law), strain_(strain), triangles_(std::move(triangles)) {
  check(law);
  require(strain == TriangleStrain::stretches || law.stress == StressMeasure::kirchhoff,
          "summed strains go with the Kirchhoff stress of a material point");
  for (const auto& t : triangles_) {
    Matrix2d flat = edges_of(t, reference).topRows<2>();
    const double area = 0.5 * flat.determinant();
    require(area > 0, "a triangle of a membrane has no area, or turns clockwise");
    Triangle state;
    state.area = area;
    state.inverse = flat.inverse();
    state_.push_back(state);
  }
}

std::vector<double> TriangleMembrane::nodal_mass(double density) const {
  std::vector<double> mass;
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    for (int node : triangles_[k]) {
      if (node >= static_cast<int>(mass.size())) mass.resize(node + 1, 0.0);
      mass[node] += density * law_.thickness * state_[k].area / 3;
    }
  }
  return mass;
}

Matrix3d TriangleMembrane::tension_of_stretches(Triangle& triangle, const Edges& gradient) const {
  const Matrix2d c = gradient.transpose() * gradient;
  const Eigen2 squares = principal(c);
  const double stretch1 = std::sqrt(squares.first);
  // From the determinant: the difference of two near numbers would lose digits.
  const double stretch2 = std::sqrt(c.determinant()) / stretch1;
  const MembraneTensions t = membrane_tensions(law_, stretch1, stretch2);
  const Vector3d n1 = gradient * squares.axis / stretch1;
  const Vector3d n2 = gradient * Vector2d(-squares.axis[1], squares.axis[0]) / stretch2;
  triangle.largest_strain = strain_of(law_.strain, stretch1).value;
  return stretch1 * t.first * n1 * n1.transpose() + stretch2 * t.second * n2 * n2.transpose();
}

Matrix3d TriangleMembrane::tension_of_sum(Triangle& triangle, const Edges& edges,
                                          const Edges& change) const {
  const Edges middle = edges - 0.5 * change;
  const Matrix3d gradient = change * surface_gradients(middle).transpose();
  triangle.strain += 0.5 * (gradient + gradient.transpose());
  const Vector3d normal = edges.col(0).cross(edges.col(1)).normalized();
  triangle.tangent = carried(triangle.tangent, triangle.normal, normal);
  triangle.normal = normal;
  Edges frame;
  frame.col(0) = triangle.tangent;
  frame.col(1) = normal.cross(triangle.tangent);
  const Eigen2 e = principal(frame.transpose() * triangle.strain * frame);
  const PrincipalStresses s = principal_stresses(law_, e.first, e.second);
  const Vector3d n1 = frame * e.axis, n2 = frame * Vector2d(-e.axis[1], e.axis[0]);
  triangle.largest_strain = e.first;
  return law_.thickness * (s.first * n1 * n1.transpose() + s.second * n2 * n2.transpose());
}

void TriangleMembrane::add_forces(const Positions& before, const Positions& position,
                                  Positions& force) {
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const auto& nodes = triangles_[k];
    Triangle& triangle = state_[k];
    const Edges edges = edges_of(nodes, position);
    const Edges change = edges - edges_of(nodes, before);
    const Matrix3d tension = strain_ == TriangleStrain::stretches
                                 ? tension_of_stretches(triangle, edges * triangle.inverse)
                                 : tension_of_sum(triangle, edges, change);
    // Tension per current width, times the width of the undeformed area: Kirchhoff.
    const Edges on_nodes = -triangle.area * tension * surface_gradients(edges);
    Matrix3d now;
    now << -on_nodes.col(0) - on_nodes.col(1), on_nodes.col(0), on_nodes.col(1);
    for (int i = 0; i < 3; ++i) force[nodes[i]] += now.col(i);
    for (int i = 0; i < 2; ++i) {
      energy_ -= 0.5 * (now.col(i + 1) + triangle.force.col(i + 1)).dot(change.col(i));
    }
    triangle.force = now;
  }
}

double TriangleMembrane::largest_strain() const {
  double largest = 0;
  for (const Triangle& t : state_) largest = std::max(largest, t.largest_strain);
  return largest;
}

SquareMesh square_mesh(double side, int n) {
  require_positive(side, "side of the square");
  require(n >= 1, "a square is divided into one or more, not " + std::to_string(n));
  SquareMesh mesh;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) mesh.nodes.push_back({side * i / n, side * j / n, 0});
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = i + (n + 1) * j, b = a + 1, c = a + n + 1, d = c + 1;
      if ((i + j) % 2 == 0) {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({a, d, c});
      } else {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({b, d, c});
      }
    }
  }
  return mesh;
}

}  // namespace zona::studies::references
