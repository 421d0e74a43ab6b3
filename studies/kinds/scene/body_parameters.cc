#include "studies/input/keys.h"
#include "studies/kinds/scene/parameters.h"
#include "studies/parameters/box.h"
#include "studies/parameters/material_parameters.h"
#include "studies/parameters/numerics_parameters.h"

namespace zona::studies {

namespace {

const std::vector<std::string> place{"x", "y", "z"};
const std::vector<std::string> time_only{"t"};
const std::vector<std::string> volumes{"box", "sphere", "cylinder", "tube", "grid"};
const std::vector<std::string> surfaces{"sheet", "disc", "icosphere"};
const std::vector<std::string> fluids{"gas", "liquid"};
const std::vector<std::string> stiff{"solid", "membrane"};
const std::vector<std::string> deformable{"solid", "gas", "liquid", "membrane"};

Parameter& required_point(Schema& schema, const std::string& key) {
  return schema.quantities(key, "m", {}).without_default().exactly(3).in("[-1e6, 1e6]");
}

Parameter& required_length(Schema& schema, const std::string& key) {
  return schema.quantity(key, "m", "").without_default().in("(0, 1e6]");
}

void declare_volumes(Schema& schema) {
  declare_box(schema, "body", "The box.", {{"shape", {"box"}}});
  required_point(schema, "body.center")
      .only_with("shape", {"sphere", "disc", "icosphere"})
      .doc("Place of its centre.");
  required_length(schema, "body.radius")
      .only_with("shape", {"sphere", "cylinder", "disc", "icosphere"})
      .doc("Radius of the shape.");
  required_point(schema, "body.from")
      .only_with("shape", {"cylinder", "tube"})
      .doc("Centre of one end.");
  required_point(schema, "body.to")
      .only_with("shape", {"cylinder", "tube"})
      .doc("Centre of the other end.");
  schema.quantity("body.inner_radius", "m", "")
      .without_default()
      .in("[0, 1e6]")
      .only_with("shape", {"tube"})
      .doc("Radius of the bore.");
  required_length(schema, "body.outer_radius").only_with("shape", {"tube"}).doc("Outer radius.");
  schema.references("body.outside", "body")
      .or_none()
      .only_with("shape", volumes)
      .doc("Bodies whose shapes are cut out of this one, so that it fills what they leave.");
}

void declare_surfaces(Schema& schema) {
  required_point(schema, "body.corner").only_with("shape", {"sheet"}).doc("One corner.");
  required_point(schema, "body.edge_u")
      .only_with("shape", {"sheet"})
      .doc("Edge of the sheet from that corner, as a vector.");
  required_point(schema, "body.edge_v")
      .only_with("shape", {"sheet"})
      .doc("The other edge from there. The normal points along edge_u x edge_v.");
  schema.choice("body.normal", {"z", "x", "y"})
      .only_with("shape", {"disc"})
      .doc("Axis that the disc stands across; its normal points along it.");
  schema.integer("body.level", 0)
      .in("[0, 9]")
      .auto_by_default()
      .only_with("shape", {"icosphere"})
      .doc(
          "How often the triangles of an icosahedron are divided in four, 10 x 4^level + 2 points; "
          "\"auto\" keeps points at most a quarter of a cell apart.");
  schema.integer("body.rings", 0)
      .in("[1, 10000]")
      .auto_by_default()
      .only_with("shape", {"disc"})
      .doc(
          "Rings of points around the centre, 6 in the first, 12 in the second, ...; \"auto\" "
          "keeps "
          "them at most a quarter of a cell apart.");
  schema.integers("body.sheet_points", {})
      .exactly(2)
      .in("[2, 100000]")
      .auto_by_default()
      .only_with("shape", {"sheet"})
      .doc(
          "Points along edge_u and edge_v; \"auto\" keeps them at most a quarter of a cell apart.");
}

void declare_shape(Schema& schema) {
  std::vector<std::string> shapes = volumes;
  shapes.insert(shapes.end(), surfaces.begin(), surfaces.end());
  schema.choice("body.shape", shapes)
      .doc(
          "What its points fill: box, sphere, cylinder, tube, or the whole grid; for a membrane a "
          "flat sheet (a parallelogram), a disc or an icosphere.");
  declare_volumes(schema);
  declare_surfaces(schema);
  schema.integers("body.points_per_cell", {2, 2, 2})
      .exactly(3)
      .or_one_for_all()
      .in("[1, 100]")
      .only_with("shape", volumes)
      .doc("Points along x, y and z that a full cell starts with.");
  schema.integers("body.points", {})
      .exactly(3)
      .auto_by_default()
      .in("[1, 100000]")
      .only_with("shape", {"box", "cylinder", "tube"})
      .doc(
          "Points of the whole body instead: along x, y and z of a box; through the wall, around "
          "and along a cylinder or tube. \"auto\" fills cells.");
}

void declare_elasticity(Schema& schema) {
  schema.quantity("body.youngs_modulus", "Pa", "")
      .without_default()
      .in("(0, 1e15]")
      .called("E")
      .only_with("material", stiff)
      .doc("Young's modulus.");
  schema.number("body.poisson_ratio", 0)
      .without_default()
      .in("(-1, 0.5)")
      .called("nu")
      .only_with("material", stiff)
      .doc("Poisson's ratio.");
}

void declare_laws(Schema& schema) {
  schema.choice("body.law", {"elastic", "elastodamage", "von_mises", "decohesion"})
      .only_with("material", stiff)
      .doc(
          "Elastic for ever; elastodamage (5.7)-(5.11); von Mises plasticity (5.12)-(5.15); or von "
          "Mises and, where the flow localises, decohesion (5.32)-(5.42).");
  declare_elastodamage(schema, "body.",
                       [](Parameter& parameter) { parameter.only_with("law", {"elastodamage"}); });
  declare_von_mises(schema, "body.", perfect_plasticity(), [](Parameter& parameter) {
    parameter.only_with("law", {"von_mises", "decohesion"});
    if (leaf(parameter.key) == "yield_strength") parameter.without_default();
  });
  declare_decohesion(schema, "body.",
                     [](Parameter& parameter) { parameter.only_with("law", {"decohesion"}); });
}

void declare_fluids_of_scene(Schema& schema) {
  schema.formula("body.pressure", "Pa", place, "0 Pa")
      .in("[-1e15, 1e15]")
      .only_with("material", fluids)
      .doc("Initial pressure. A gas needs a positive one.");
  schema.number("body.gamma", 1.4)
      .in("(1, 10]")
      .called("gamma")
      .only_with("material", {"gas"})
      .doc("Ratio of heat capacities of an ideal gas (4.31).");
  schema.number("body.grueneisen", 4)
      .in("(0, 100]")
      .called("Gamma")
      .only_with("material", {"liquid"})
      .doc("Parameter of the stiffened-gas equation of state (5.1); water by default.");
  schema.quantity("body.p_infinity", "Pa", "6.13e8 Pa")
      .in("(0, 1e15]")
      .called("P_inf")
      .only_with("material", {"liquid"})
      .doc("Stiffness pressure of the stiffened-gas equation of state (5.1); water by default.");
  schema.quantity("body.viscosity", "Pa s", "0 Pa s")
      .in("[0, 1e9]")
      .called("mu")
      .only_with("material", fluids)
      .doc("Shear viscosity; Stokes' condition holds (4.28).");
  declare_energy_increment(schema, "body.energy_increment").only_with("material", fluids);
  schema.number("body.artificial_viscosity_quadratic", 0)
      .in("[0, 100]")
      .called("c_0")
      .only_with("material", fluids)
      .doc("Quadratic coefficient of the artificial viscosity (4.45).");
  schema.number("body.artificial_viscosity_linear", 0)
      .in("[0, 100]")
      .called("c_1")
      .only_with("material", fluids)
      .doc("Linear coefficient of the artificial viscosity (4.45).");
}

void declare_membrane(Schema& schema) {
  required_length(schema, "body.thickness")
      .only_with("material", {"membrane"})
      .doc("Thickness at first.");
  schema.choice("body.kinematics", {"source", "objective"})
      .only_with("material", {"membrane"})
      .doc(
          "Strain of the membrane: accumulated in fixed axes and rotated (4.10), (4.21), as the "
          "source; or objective, from the deformation gradient of the triangles.");
  declare_one_way(schema, "body.",
                  [](Parameter& parameter) { parameter.only_with("material", {"membrane"}); });
  declare_stress_update(schema, "body.", [](Parameter& parameter) {
    parameter.only_with("material", {"membrane"}).only_with("law", {"elastic"});
  });
  declare_localization(schema, "body.", [](Parameter& parameter) {
    parameter.only_with("material", {"membrane"}).only_with("law", {"decohesion"});
  });
}

void declare_motion_of_body(Schema& schema) {
  schema.formulas("body.velocity", "m/s", place, {"0", "0", "0"})
      .exactly(3)
      .in("[-1e9, 1e9]")
      .only_with("material", deformable)
      .doc("Initial velocity.");
  schema.formulas("body.displacement", "m", time_only, {"0", "0", "0"})
      .exactly(3)
      .in("[-1e6, 1e6]")
      .only_with("material", {"rigid"})
      .doc("Displacement from the initial place; 0 for a body that is fixed.");
  schema.choice("body.drive", {"points", "nodes"})
      .only_with("material", {"rigid"})
      .doc(
          "What carries the motion: the body's points, which the grid mixes with their "
          "surroundings "
          "by mass, or every node that they touch, which is harsher but yields to nothing.");
}

}  // namespace

void declare_scene_bodies(Schema& schema) {
  schema.list(
      "body",
      "Bodies of material points, each of one material. Bodies that share nodes of the grid "
      "stick to each other.",
      1, true);
  declare_shape(schema);
  schema.choice("body.material", {"solid", "gas", "liquid", "membrane", "rigid"})
      .doc(
          "A solid in rate form (3.41)-(3.42); an ideal gas (4.31); a liquid, that is a "
          "stiffened "
          "gas (5.1); a membrane (4.1); or a rigid body that moves as prescribed.");
  schema.formula("body.density", "kg/m^3", place, "")
      .without_default()
      .in("(0, 1e9]")
      .called("rho")
      .doc("Initial density; constant for membranes and rigid bodies.");
  declare_elasticity(schema);
  declare_laws(schema);
  declare_membrane(schema);
  declare_fluids_of_scene(schema);
  declare_volume_average(schema, "body.average_volume_strain")
      .only_with("material", {"solid", "gas", "liquid"});
  declare_motion_of_body(schema);
}

}  // namespace zona::studies
