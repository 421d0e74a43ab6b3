#include "studies/kinds/piercing/parameters.h"

#include "studies/parameters/material_parameters.h"
#include "studies/parameters/numerics_parameters.h"
#include "studies/parameters/shared_parameters.h"

namespace zona::studies {

namespace {

/// A stiffened-gas fluid (4.28)-(4.45); only p_infinity and the number of points differ.
void declare_fluid(Schema& schema, const std::string& name, const std::string& p_infinity,
                   long points_per_cell) {
  schema.quantity(name + ".density", "kg/m^3", "1000 kg/m^3")
      .in("(0, 30000]")
      .called("rho")
      .doc("Initial density (5.4).");
  schema.number(name + ".grueneisen", 4)
      .in("(0, 100]")
      .called("Gamma")
      .doc("Fit parameter of the stiffened-gas equation of state (Table 5.3).");
  schema.quantity(name + ".p_infinity", "Pa", p_infinity)
      .in("(0, 1e12]")
      .called("P_inf")
      .doc("Stiffness pressure of the stiffened-gas equation of state (Table 5.3).");
  schema.quantity(name + ".viscosity", "Pa s", "8.9e-4 Pa s")
      .in("[0, 1e3]")
      .called("mu")
      .doc("Shear viscosity; Stokes' condition holds (5.4).");
  schema.integer(name + ".points_per_cell", points_per_cell)
      .one_of({1, 8, 27, 64})
      .doc(
          "Material points that a full cell starts with, the cube of the number along an edge "
          "(5.4).");
  schema.number(name + ".artificial_viscosity_quadratic", 0)
      .in("[0, 100]")
      .called("c_0")
      .doc(
          "Quadratic coefficient of the artificial viscosity (4.45); the source uses none in "
          "piercings.");
  schema.number(name + ".artificial_viscosity_linear", 0)
      .in("[0, 100]")
      .called("c_1")
      .doc(
          "Linear coefficient of the artificial viscosity (4.45); the source uses none in "
          "piercings.");
}

void declare_zona_law(Schema& schema) {
  schema.choice("zona.law", {"elastodamage", "decohesion", "elastic"})
      .doc(
          "Elastodamage (5.7)-(5.11); von Mises plasticity (5.12)-(5.15) and, where it localises, "
          "decohesion (5.32)-(5.42); or elastic for ever.");
  declare_elastodamage(schema, "zona.");
  declare_von_mises(schema, "zona.", zona_plasticity());
  declare_decohesion(schema, "zona.");
  declare_localization(schema, "zona.");
  schema.choice("zona.kinematics", {"source", "objective"})
      .doc(
          "Strain of the membrane: accumulated in fixed axes and rotated (4.10), (4.21), as the "
          "source; or objective, from the deformation gradient of the triangles.");
  declare_one_way(schema, "zona.");
  declare_stress_update(schema, "zona.");
}

}  // namespace

void declare_grid(Schema& schema) {
  schema.section("grid", "The background grid of cubic cells.");
  schema.quantity("grid.cell", "m", "6 um")
      .in("[1e-9, 1e-3]")
      .called("Delta x")
      .doc("Side length of a cell; the source uses 4, 5 and 6 um (Table 5.4).");
  schema.quantity("grid.domain", "m", "150 um")
      .in("(0, 0.1]")
      .doc(
          "Side length of the cubic domain, rounded to whole cells. Not given in the source; 25 "
          "cells of 6 um reproduce Table 5.4, as do about 140 um at 5 um and 128 um at 4 um.");
}

void declare_zona(Schema& schema) {
  schema.section("zona", "The zona pellucida: a spherical membrane of triangles.");
  schema.quantity("zona.diameter", "m", "100 um")
      .in("(0, 0.01]")
      .doc("Diameter of the oocyte (5.4).");
  schema.quantity("zona.thickness", "m", "8 um")
      .in("(0, 1e-3]")
      .doc("Thickness of the membrane (5.4).");
  schema.integer("zona.level", 6)
      .in("[1, 9]")
      .doc(
          "How often the triangles of an icosahedron are divided in four; 6 gives the 40962 "
          "points and 81920 triangles of 5.4.");
  schema.quantity("zona.youngs_modulus", "Pa", "17.9 kPa")
      .in("(0, 1e12]")
      .called("E")
      .doc("Young's modulus (Table 5.2).");
  schema.number("zona.poisson_ratio", 0.49)
      .in("(-1, 0.5)")
      .called("nu")
      .doc("Poisson's ratio (Table 5.2).");
  schema.quantity("zona.density", "kg/m^3", "1100 kg/m^3")
      .in("(0, 30000]")
      .called("rho")
      .doc("Density (5.4).");
  declare_zona_law(schema);
}

void declare_fluids(Schema& schema) {
  schema.section("cytoplasm", "The fluid in the zona.");
  declare_fluid(schema, "cytoplasm", "2.12e8 Pa", 27);
  schema.section("medium", "The fluid around the zona.");
  declare_fluid(schema, "medium", "6.13e8 Pa", 1);
}

void declare_pipette_tip(Schema& schema, const std::string& point_density) {
  schema.section("pipette", "The tip of the injection pipette, a tube that moves as prescribed.");
  declare_pipette_bore(schema, "pipette");
  schema.quantity("pipette.tip_length", "m", "15 um")
      .in("(0, 0.01]")
      .doc("Length of the tip that the simulation holds (5.4).");
  schema.integers("pipette.points", {2, 60, 45})
      .exactly(3)
      .in("[1, 10000]")
      .doc("Points through the wall, around and along the tip; 5400 in all (5.4).");
  schema.quantity("pipette.density", "kg/m^3", "2300 kg/m^3")
      .in("(0, 30000]")
      .doc("Density of the glass (5.4).");
  schema.quantity("pipette.point_density", "kg/m^3", point_density)
      .in("(0, 1e6]")
      .or_auto()
      .doc(
          "Density of the tip's points. \"auto\" spreads the fluid of the bore evenly over the "
          "glass: 26478 kg/m^3 with mercury, where the source states 26441 (5.4). The motion is "
          "prescribed, "
          "so this mass only sets how firmly the tip holds the grid around it: comparisons keep "
          "the "
          "source's value for every fill, lest a light fill seem to slip.");
  schema.choice("pipette.drive", {"points", "nodes"})
      .doc(
          "What carries the prescribed motion: the pipette's points, which the grid mixes with "
          "their surroundings by mass (the source), or every node that they touch, which is much "
          "harsher.");
}

void declare_holding_plate(Schema& schema) {
  schema.section("plate", "The holding pipette, a square plate at rest behind the oocyte.");
  schema.boolean("plate.enabled", true).doc("Whether there is a plate.");
  schema.quantity("plate.side", "m", "72 um")
      .in("(0, 0.1]")
      .doc("Side length (5.4: 72 um with cells of 4 and 6 um, 70 um with 5 um).");
  schema.integer("plate.thickness_cells", 3).in("[1, 1000]").doc("Thickness in cells (5.4).");
  schema.quantity("plate.density", "kg/m^3", "2300 kg/m^3")
      .in("(0, 30000]")
      .doc("Density of the glass (5.4).");
}

void declare_window(Schema& schema) {
  schema.quantity("motion.ramp", "s", "0 s")
      .in("[0, 1]")
      .doc(
          "Time over which the motion fades in smoothly; none in the source, whose sine starts "
          "with 0.85 m/s at once.");
  schema.quantity("motion.window_start", "s", "auto")
      .in("[0, 10]")
      .or_auto()
      .doc(
          "Time of the beam's or the trace's history at which the piercing starts; \"auto\" when "
          "the tip first moves by auto_fraction of its peak.");
  schema.quantity("motion.window_length", "s", "300 us")
      .in("(0, 10]")
      .doc(
          "How much of the history is used. The tip answers about 100 us after a 60 us pulse and "
          "then swings with half-periods of 50 to 100 us.");
  schema.number("motion.auto_fraction", 0.01)
      .in("(0, 1)")
      .doc("Fraction of the tip's peak displacement that starts an \"auto\" window.");
}

void declare_beam_drive(Schema& schema) {
  schema.section("beam", "The pipette as a beam, which moves the tip when motion.kind = \"beam\".");
  declare_beam(schema, "beam", 80);
  declare_beam_integration(schema, "beam", {"modal", "newmark", "arkode", "transform"});
  declare_columns(schema);
  declare_bath(schema);
  schema.section("pulse", "The motion of the beam's support, when motion.kind = \"beam\".");
  declare_pulse_form(schema, {"triangular", "trapezoid", "half_sine", "trace"});
  schema.quantity("pulse.duration", "s", "60 us").in("(0, 1]").doc("Duration of the pulse (5.4).");
}

void declare_piercing_numerics(Schema& schema) {
  schema.section("numerics", "Choices of the scheme; the defaults are the source's.");
  declare_interpolation(schema, "numerics.interpolation");
  declare_volume_average(schema, "numerics.average_volume_strain");
  declare_energy_increment(schema, "numerics.energy_increment");
  declare_pic_and_damping(schema);
}

void declare_piercing_run(Schema& schema) {
  schema.section("time", "Time integration of the piercing.");
  schema.quantity("time.end", "s", "auto")
      .in("(0, 10]")
      .or_auto()
      .doc(
          "End of the simulation; \"auto\" is one period of a sine, the duration of a triangle, "
          "the window of a beam or a trace.");
  schema.quantity("time.step", "s", "auto")
      .in("(0, 1]")
      .or_auto()
      .called("Delta t")
      .doc("Time step; \"auto\" is courant times the critical step (the source: 0.5 ns).");
  schema.number("time.courant", 0.8)
      .in("(0, 1]")
      .doc(
          "Fraction of the critical step, cell / wave speed, that an \"auto\" step takes at most.");
  schema.section("boundary", "The faces of the domain.");
  schema.choice("boundary.kind", {"absorbing", "free", "fixed", "roller"})
      .doc(
          "Viscous stresses that absorb outgoing waves (5.43)-(5.50), nothing, no motion, or no "
          "motion through the face.");
  schema.section("output", "What is written into the run directory.");
  schema.quantity("output.history_interval", "s", "0.1 us")
      .in("(0, 1]")
      .doc("Time between two rows of history.csv.");
  schema.quantity("output.fields_interval", "s", "4 us")
      .in("(0, 1]")
      .doc("Time between two frames of fields.h5; 4 us meets the instants of Figures 5.16-5.21.");
  schema.boolean("output.fields", true).doc("Whether fields are written at all.");
  declare_run(schema);
}

}  // namespace zona::studies
