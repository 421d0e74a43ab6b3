#include "studies/kinds/scene/shape.h"

#include <Eigen/Geometry>
#include <cmath>

namespace zona::studies {

namespace {

using Eigen::Vector3d;

Vector3d vector_of(const std::vector<double>& v) {
  return {v[0], v[1], v[2]};
}

mpm::Tube tube_of(const Table& body) {
  const Vector3d from = vector_of(body.quantities("from"));
  const Vector3d along = vector_of(body.quantities("to")) - from;
  const bool solid = body.choice("shape") == "cylinder";
  return {from, along.normalized(), along.norm(), solid ? 0 : body.quantity("inner_radius"),
          body.quantity(solid ? "radius" : "outer_radius")};
}

bool contains(const mpm::Tube& tube, const Vector3d& place) {
  const Vector3d from_end = place - tube.end;
  const double along = from_end.dot(tube.axis);
  const double radius = (from_end - along * tube.axis).norm();
  return along >= 0 && along < tube.length && radius >= tube.inner_radius &&
         radius < tube.outer_radius;
}

std::array<int, 3> three(const std::vector<long>& n) {
  return {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2])};
}

/// Parts of a length that are at most a quarter of the shortest cell edge: closer than what tears
/// (half a cell), so that nodes which the membrane only grazes still see several points.
int intervals(double length, const mpm::BackgroundGrid& grid) {
  return std::max(1, static_cast<int>(std::ceil(4 * length / grid.cell_size().minCoeff() - 1e-9)));
}

int icosphere_level(const Table& body, double radius, const mpm::BackgroundGrid& grid) {
  if (!body.is_auto("level")) return static_cast<int>(body.integer("level"));
  const double edge = std::atan(2.0) * radius;  // of the icosahedron, along the sphere
  return std::max(0, static_cast<int>(std::ceil(std::log2(intervals(edge, grid)))));
}

mpm::TriangulatedSurface sheet_of(const Table& body, const mpm::BackgroundGrid& grid) {
  const Vector3d u = vector_of(body.quantities("edge_u"));
  const Vector3d v = vector_of(body.quantities("edge_v"));
  int count[2] = {intervals(u.norm(), grid) + 1, intervals(v.norm(), grid) + 1};
  if (!body.is_auto("sheet_points")) {
    const std::vector<long> given = body.integers("sheet_points");
    for (int i = 0; i < 2; ++i) count[i] = static_cast<int>(given[i]);
  }
  return mpm::sheet(vector_of(body.quantities("corner")), u, v, count[0], count[1]);
}

mpm::TriangulatedSurface make_surface(const Table& body, const mpm::BackgroundGrid& grid) {
  const std::string& shape = body.choice("shape");
  if (shape == "sheet") return sheet_of(body, grid);
  const Vector3d center = vector_of(body.quantities("center"));
  const double radius = body.quantity("radius");
  if (shape == "icosphere") {
    return mpm::icosphere(center, radius, icosphere_level(body, radius, grid));
  }
  const int rings =
      body.is_auto("rings") ? intervals(radius, grid) : static_cast<int>(body.integer("rings"));
  return mpm::disc(center, body.choice("normal")[0] - 'x', radius, rings);
}

/// Points of a body that is cut into equal parts whatever the cells.
mpm::Lattice counted_points(const Table& body, const mpm::BackgroundGrid& grid) {
  const auto count = three(body.integers("points"));
  if (body.choice("shape") != "box") return mpm::tube(tube_of(body), count[0], count[1], count[2]);
  const mpm::Box box = box_of(body, grid);
  return mpm::box(box.low, box.high, count);
}

}  // namespace

Inside inside_of(const Table& body, const mpm::BackgroundGrid& grid) {
  const std::string& shape = body.choice("shape");
  if (shape == "grid") return [](const Vector3d&) { return true; };
  if (shape == "sheet" || shape == "disc") return [](const Vector3d&) { return false; };
  if (shape == "box") {
    return [box = box_of(body, grid)](const Vector3d& x) {
      return (x.array() >= box.low.array()).all() && (x.array() < box.high.array()).all();
    };
  }
  if (shape == "cylinder" || shape == "tube") {
    return [tube = tube_of(body)](const Vector3d& x) { return contains(tube, x); };
  }
  return [center = vector_of(body.quantities("center")), radius = body.quantity("radius")](
             const Vector3d& x) { return (x - center).norm() < radius; };
}

mpm::Lattice volume_points(const Table& body, const mpm::BackgroundGrid& grid, const Inside& inside,
                           const Inside& cut) {
  const bool by_cell = !body.applies("points") || body.is_auto("points");
  if (by_cell) {
    return mpm::fill_cells(grid, three(body.integers("points_per_cell")),
                           [&](const Vector3d& x) { return inside(x) && !cut(x); });
  }
  const mpm::Lattice all = counted_points(body, grid);
  mpm::Lattice kept;
  for (std::size_t p = 0; p < all.places.size(); ++p) {
    if (!cut(all.places[p])) kept.add(all.places[p], all.volumes[p]);
  }
  return kept;
}

WeightedSurface surface_points(const Table& body, const mpm::BackgroundGrid& grid) {
  WeightedSurface result{mpm::in_traversal_order(make_surface(body, grid), grid), {}};
  const auto& places = result.surface.places;
  result.areas.assign(places.size(), 0.0);
  for (const auto& [a, b, c] : result.surface.triangles) {
    const double area = (places[b] - places[a]).cross(places[c] - places[a]).norm() / 2;
    for (int vertex : {a, b, c}) result.areas[vertex] += area / 3;
  }
  return result;
}

bool is_surface(const std::string& shape) {
  return shape == "sheet" || shape == "disc" || shape == "icosphere";
}

}  // namespace zona::studies
