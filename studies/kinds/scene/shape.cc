#include "studies/kinds/scene/shape.h"

#include <Eigen/Geometry>
#include <cmath>

namespace zona::studies {

namespace {

using Eigen::Vector3d;

mpm::Tube tube_of(const BodyShape& body) {
  const Vector3d along = body.to - body.from;
  const bool solid = body.shape == ShapeName::cylinder;
  return {body.from, along.normalized(), along.norm(), solid ? 0 : body.inner_radius,
          solid ? body.radius : body.outer_radius};
}

bool contains(const mpm::Tube& tube, const Vector3d& place) {
  const Vector3d from_end = place - tube.end;
  const double along = from_end.dot(tube.axis);
  const double radius = (from_end - along * tube.axis).norm();
  return along >= 0 && along < tube.length && radius >= tube.inner_radius &&
         radius < tube.outer_radius;
}

/// Parts of a length that are at most a quarter of the shortest cell edge: closer than what tears
/// (half a cell), so that nodes which the membrane only grazes still see several points.
int intervals(double length, const mpm::BackgroundGrid& grid) {
  return std::max(1, static_cast<int>(std::ceil(4 * length / grid.cell_size().minCoeff() - 1e-9)));
}

int icosphere_level(const BodyShape& body, const mpm::BackgroundGrid& grid) {
  if (body.level) return *body.level;
  const double edge = std::atan(2.0) * body.radius;  // of the icosahedron, along the sphere
  return std::max(0, static_cast<int>(std::ceil(std::log2(intervals(edge, grid)))));
}

mpm::TriangulatedSurface sheet_of(const BodyShape& body, const mpm::BackgroundGrid& grid) {
  const auto [along_u, along_v] = body.sheet_points.value_or(std::array<int, 2>{
      intervals(body.edge_u.norm(), grid) + 1, intervals(body.edge_v.norm(), grid) + 1});
  return mpm::sheet(body.corner, body.edge_u, body.edge_v, along_u, along_v);
}

mpm::TriangulatedSurface make_surface(const BodyShape& body, const mpm::BackgroundGrid& grid) {
  if (body.shape == ShapeName::sheet) return sheet_of(body, grid);
  if (body.shape == ShapeName::icosphere)
    return mpm::icosphere(body.center, body.radius, icosphere_level(body, grid));
  const int rings = body.rings ? *body.rings : intervals(body.radius, grid);
  return mpm::disc(body.center, body.normal, body.radius, rings);
}

/// Points of a body that is cut into equal parts, independent of the cells.
mpm::Lattice counted_points(const BodyShape& body, const mpm::BackgroundGrid& grid) {
  const auto& count = *body.points;
  if (body.shape != ShapeName::box) return mpm::tube(tube_of(body), count[0], count[1], count[2]);
  const mpm::Box box = body.in(grid);
  return mpm::box(box.low, box.high, count);
}

}  // namespace

Inside inside_of(const BodyShape& body, const mpm::BackgroundGrid& grid) {
  switch (body.shape) {
    case ShapeName::grid:
      return [](const Vector3d&) { return true; };
    case ShapeName::sheet:
    case ShapeName::disc:
      return [](const Vector3d&) { return false; };
    case ShapeName::box:
      return [box = body.in(grid)](const Vector3d& x) {
        return (x.array() >= box.low.array()).all() && (x.array() < box.high.array()).all();
      };
    case ShapeName::cylinder:
    case ShapeName::tube:
      return [tube = tube_of(body)](const Vector3d& x) { return contains(tube, x); };
    case ShapeName::sphere:
    case ShapeName::icosphere:
      break;
  }
  return [center = body.center, radius = body.radius](const Vector3d& x) {
    return (x - center).norm() < radius;
  };
}

mpm::Lattice volume_points(const BodyShape& body, const mpm::BackgroundGrid& grid,
                           const Inside& inside, const Inside& cut) {
  if (!body.points) {
    return mpm::fill_cells(grid, body.points_per_cell,
                           [&](const Vector3d& x) { return inside(x) && !cut(x); });
  }
  const mpm::Lattice all = counted_points(body, grid);
  mpm::Lattice kept;
  for (std::size_t p = 0; p < all.places.size(); ++p) {
    if (!cut(all.places[p])) kept.add(all.places[p], all.volumes[p]);
  }
  return kept;
}

WeightedSurface surface_points(const BodyShape& body, const mpm::BackgroundGrid& grid) {
  WeightedSurface result{mpm::in_traversal_order(make_surface(body, grid), grid), {}};
  const auto& places = result.surface.places;
  result.areas.assign(places.size(), 0.0);
  for (const auto& [a, b, c] : result.surface.triangles) {
    const double area = (places[b] - places[a]).cross(places[c] - places[a]).norm() / 2;
    for (int vertex : {a, b, c}) result.areas[vertex] += area / 3;
  }
  return result;
}

}  // namespace zona::studies
