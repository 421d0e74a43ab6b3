#include "studies/kinds/scene/shape_table.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "studies/kinds/scene/grid_table.h"
#include "studies/parameters/axes.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;
using Keys = TableKeys<BodyShape>;

const std::vector<ShapeName> kVolumes{ShapeName::box, ShapeName::sphere, ShapeName::cylinder,
                                      ShapeName::tube, ShapeName::grid};

Condition of(const Keys& keys, const std::vector<ShapeName>& shapes) {
  return keys.is(&BodyShape::shape, shape_names(), shapes);
}

Parameter& required_point(Keys& keys, const char* leaf, Vector3d BodyShape::*member) {
  return keys.quantities(leaf, member, "m", {}).without_default().exactly(3).in("[-1e6, 1e6]");
}

Parameter& required_length(Keys& keys, const char* leaf, double BodyShape::*member,
                           const std::string& allowed) {
  return keys.quantity(leaf, member, "m", "").without_default().in(allowed);
}

void declare_volumes(Keys& keys) {
  const Condition rod = of(keys, {ShapeName::cylinder, ShapeName::tube});
  const Condition tube = of(keys, {ShapeName::tube});
  declare_box(keys, "The box.", {of(keys, {ShapeName::box})});
  required_point(keys, "center", &BodyShape::center)
      .only_where(of(keys, {ShapeName::sphere, ShapeName::disc, ShapeName::icosphere}))
      .doc("Place of its centre.");
  required_length(keys, "radius", &BodyShape::radius, "(0, 1e6]")
      .only_where(
          of(keys, {ShapeName::sphere, ShapeName::cylinder, ShapeName::disc, ShapeName::icosphere}))
      .doc("Radius of the shape.");
  required_point(keys, "from", &BodyShape::from).only_where(rod).doc("Centre of one end.");
  required_point(keys, "to", &BodyShape::to).only_where(rod).doc("Centre of the other end.");
  required_length(keys, "inner_radius", &BodyShape::inner_radius, "[0, 1e6]")
      .only_where(tube)
      .doc("Radius of the bore.");
  required_length(keys, "outer_radius", &BodyShape::outer_radius, "(0, 1e6]")
      .only_where(tube)
      .doc("Outer radius.");
  keys.references("outside", &BodyShape::outside, keys.section())
      .or_none()
      .only_where(of(keys, kVolumes))
      .doc("Bodies whose shapes are cut out of this one.");
}

void declare_sheet(Keys& keys, const Condition& sheet) {
  required_point(keys, "corner", &BodyShape::corner).only_where(sheet).doc("One corner.");
  required_point(keys, "edge_u", &BodyShape::edge_u)
      .only_where(sheet)
      .doc("Edge of the sheet from that corner, as a vector.");
  required_point(keys, "edge_v", &BodyShape::edge_v)
      .only_where(sheet)
      .doc("The other edge from there. The normal points along edge_u x edge_v.");
}

void declare_surfaces(Keys& keys) {
  const Condition sheet = of(keys, {ShapeName::sheet});
  const Condition disc = of(keys, {ShapeName::disc});
  declare_sheet(keys, sheet);
  keys.choice("normal", &BodyShape::normal, kAxisNames, kAxisNames.back().value)
      .only_where(disc)
      .doc("Axis along the normal of the disc.");
  keys.integer("level", &BodyShape::level, 0)
      .in("[0, 9]")
      .auto_by_default()
      .only_where(of(keys, {ShapeName::icosphere}))
      .doc(
          "Number of subdivisions of an icosahedron, each of which divides every triangle into "
          "four: 10 x 4^level + 2 points; "
          "\"auto\" keeps points at most a quarter of a cell apart.");
  keys.integer("rings", &BodyShape::rings, 0)
      .in("[1, 10000]")
      .auto_by_default()
      .only_where(disc)
      .doc(
          "Rings of points around the centre, 6 in the first, 12 in the second, ...; \"auto\" "
          "keeps them at most a quarter of a cell apart.");
  keys.integers("sheet_points", &BodyShape::sheet_points, {})
      .exactly(2)
      .in("[2, 100000]")
      .auto_by_default()
      .only_where(sheet)
      .doc(
          "Points along edge_u and edge_v; \"auto\" keeps them at most a quarter of a cell apart.");
}

void declare_points(Keys& keys) {
  keys.integers("points_per_cell", &BodyShape::points_per_cell, {2, 2, 2})
      .exactly(3)
      .or_one_for_all()
      .in("[1, 100]")
      .only_where(of(keys, kVolumes))
      .doc("Initial points of a full cell along x, y and z.");
  keys.integers("points", &BodyShape::points, {})
      .exactly(3)
      .auto_by_default()
      .in("[1, 100000]")
      .only_where(of(keys, {ShapeName::box, ShapeName::cylinder, ShapeName::tube}))
      .doc(
          "Points of the whole body instead: along x, y and z of a box; through the wall, around "
          "and along a cylinder or tube. \"auto\" fills cells.");
}

void check_corners(const Table& body, const Complain& complain) {
  check_box<BodyShape>(body, complain, false);
}

void check_rod(const Table& body, const Complain& complain) {
  if (body.applies(&BodyShape::from)) {
    const Vector3d along = body.value(&BodyShape::to) - body.value(&BodyShape::from);
    if (!(along.norm() > 0))
      complain(body.leaf(&BodyShape::to), "is the same place as from; needs another");
  }
  if (!body.applies(&BodyShape::inner_radius)) return;
  const double inner = body.value(&BodyShape::inner_radius);
  const double outer = body.value(&BodyShape::outer_radius);
  if (inner >= outer)
    complain(body.leaf(&BodyShape::inner_radius),
             fmt::format("{:g} m is not less than {}, {:g} m", inner,
                         body.leaf(&BodyShape::outer_radius), outer));
}

void check_edges(const Table& body, const Complain& complain) {
  if (!body.applies(&BodyShape::edge_u)) return;
  const Vector3d u = body.value(&BodyShape::edge_u), v = body.value(&BodyShape::edge_v);
  if (u.cross(v).norm() > 1e-9 * u.norm() * v.norm()) return;
  complain(body.leaf(&BodyShape::edge_v),
           "has no length or runs along edge_u; needs another direction");
}

void check_points(const Table& body, const Complain& complain) {
  if (!body.applies(&BodyShape::points_per_cell)) return;
  const Configuration& study = body.study();
  const Vector3d extent = study.value(&SceneGrid::high) - study.value(&SceneGrid::low);
  const Vector3d cell = study.value(&SceneGrid::cell);
  const std::array<int, 3> per_cell = body.value(&BodyShape::points_per_cell);
  double points = 1;
  for (int axis = 0; axis < 3; ++axis) points *= extent[axis] / cell[axis] * per_cell[axis];
  if (points > 2e9) {
    complain(body.leaf(&BodyShape::points_per_cell),
             fmt::format("a full grid would have {:g} points; at most 2e9 are allowed", points));
  }
}

}  // namespace

const Words<ShapeName>& shape_names() {
  static const Words<ShapeName> words{
      {"box", ShapeName::box},           {"sphere", ShapeName::sphere},
      {"cylinder", ShapeName::cylinder}, {"tube", ShapeName::tube},
      {"grid", ShapeName::grid},         {"sheet", ShapeName::sheet},
      {"disc", ShapeName::disc},         {"icosphere", ShapeName::icosphere}};
  return words;
}

bool is_surface(ShapeName shape) {
  return shape == ShapeName::sheet || shape == ShapeName::disc || shape == ShapeName::icosphere;
}

void declare_shape(Schema& schema, const std::string& section) {
  Keys keys(schema, section);
  keys.choice("shape", &BodyShape::shape, shape_names())
      .doc(
          "What its points fill: box, sphere, cylinder, tube, or the whole grid; for a membrane a "
          "flat sheet (a parallelogram), a disc or an icosphere.");
  declare_volumes(keys);
  declare_surfaces(keys);
  declare_points(keys);
  schema.check_each(section, check_corners);
  schema.check_each(section, check_rod);
  schema.check_each(section, check_edges);
  schema.check_each(section, check_points);
}

}  // namespace zona::studies
