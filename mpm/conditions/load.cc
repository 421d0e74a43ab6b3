#include "mpm/conditions/load.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "mpm/grid/shape_functions.h"
#include "mpm/points/errors.h"

namespace zona::mpm {

namespace {

std::size_t index_of(const std::string& name, const std::vector<Body>& bodies) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].name == name) return b;
  }
  throw ModelError(fmt::format("a load acts on the body '{}', which does not exist", name));
}

/// Each point's mass over that of all points in the region, by id.
std::vector<double> shares(const BodyForce& load, const Body& body) {
  if (body.prescribed()) {
    throw ModelError(
        fmt::format("a force cannot act on body '{}', whose motion is prescribed", load.body));
  }
  std::vector<double> share(body.points.size(), 0.0);
  double mass = 0;
  for (int p = 0; p < body.points.size(); ++p) {
    if (!load.region.contains(body.points.position_of(p))) continue;
    mass += body.points.mass[p];
    share[body.points.id[p]] = body.points.mass[p];
  }
  if (!(mass > 0)) {
    throw ModelError(fmt::format(
        "a force acts on body '{}', which has no points in [{}, {}] x [{}, {}] x [{}, {}] m",
        load.body, load.region.low.x(), load.region.high.x(), load.region.low.y(),
        load.region.high.y(), load.region.low.z(), load.region.high.z()));
  }
  for (double& s : share) s /= mass;
  return share;
}

/// Sum over the intact triangles around a point of a third of their area vectors [m^2].
Eigen::Vector3d area_vector(const Surface& surface, const MaterialPoints& points, int p) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int* t = surface.triangles_begin(p); t != surface.triangles_end(p); ++t) {
    if (!surface.intact(*t)) continue;
    const Triangle& v = surface.triangles()[*t];
    const Eigen::Vector3d a = points.position_of(v[0]);
    sum += (points.position_of(v[1]) - a).cross(points.position_of(v[2]) - a) / 6;
  }
  return sum;
}

/// Adds force(point) [N] of the points of a cell to its nodes.
template <class Shape, class Force>
void add_to_nodes(const MaterialPoints& points, const Cell& cell, const int* begin, const int* end,
                  BackgroundGrid& grid, Force force) {
  typename Shape::VectorSums sums(grid, cell);
  for_each_group(begin, end, [&](const PointGroup& group) {
    PointVectors at;
    const auto natural = cell.natural(group.load(points.position));
    for (int axis = 0; axis < 3; ++axis) store(at.natural[axis], natural[axis]);
    for (int p = 0; p < group.count(); ++p) {
      const Eigen::Vector3d f = force(group[p]);
      for (int axis = 0; axis < 3; ++axis) at.vector[axis][p] = f[axis];
      sums.add(at, p);
    }
  });
  sums.for_each_node(cell, grid, [&](int node, const HalfLanes& sum) {
    grid.state[node] += Lanes{0, 0, 0, 0, sum[0], sum[1], sum[2], 0};
  });
}

template <class Force>
void add_to_nodes(const Body& body, int b, BackgroundGrid& grid, Force force) {
  with_shape_functions(grid, [&](auto shape) {
    for_each_cell(grid, b, body.cells.brick(b),
                  [&](const Cell& cell, const int* begin, const int* end, int) {
                    add_to_nodes<decltype(shape)>(body.points, cell, begin, end, grid, force);
                  });
  });
}

}  // namespace

Loads::Loads(const std::vector<BodyForce>& forces, const std::vector<SurfacePressure>& pressures,
             const std::vector<Body>& bodies) {
  for (const auto& load : forces) {
    if (!load.force) throw ModelError(fmt::format("a force on body '{}' has no value", load.body));
    const std::size_t b = index_of(load.body, bodies);
    forces_.push_back({b, shares(load, bodies[b]), load.force, Eigen::Vector3d::Zero()});
  }
  for (const auto& load : pressures) {
    if (!load.pressure)
      throw ModelError(fmt::format("a pressure on body '{}' has no value", load.body));
    const std::size_t b = index_of(load.body, bodies);
    if (!bodies[b].membrane()) {
      throw ModelError(
          fmt::format("body '{}' is no membrane: a pressure needs a surface", load.body));
    }
    pressures_.push_back({b, load.pressure, 0});
  }
}

void Loads::evaluate(double time) {
  for (auto& load : forces_) load.now = load.at(time);
  for (auto& load : pressures_) load.now = load.at(time);
}

void Loads::add_brick(const std::vector<Body>& bodies, int b, BackgroundGrid& grid) const {
  for (const auto& load : forces_) {
    const Body& body = bodies[load.body];
    add_to_nodes(body, b, grid, [&](int p) -> Eigen::Vector3d {
      return load.share[body.points.id[p]] * load.now;
    });
  }
  for (const auto& load : pressures_) {
    const Body& body = bodies[load.body];
    const Surface& surface = body.membrane()->surface;
    add_to_nodes(body, b, grid, [&](int p) -> Eigen::Vector3d {
      return load.now * area_vector(surface, body.points, p);
    });
  }
}

}  // namespace zona::mpm
