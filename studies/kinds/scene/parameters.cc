#include "studies/kinds/scene/parameters.h"

#include "studies/parameters/box.h"
#include "studies/parameters/numerics_parameters.h"
#include "studies/parameters/shared_parameters.h"

#include <limits>

namespace zona::studies {

namespace {

const std::vector<std::string> time_only{"t"};

void declare_faces(Schema& schema) {
  schema.section("boundary", "The six faces of the grid.");
  const char* names[6] = {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};
  for (const char* name : names) {
    schema.choice(std::string("boundary.") + name, {"free", "roller", "fixed", "absorbing"})
        .doc(
            "Nothing (a point that leaves the grid ends the run), no motion through the face, no "
            "motion at all, or viscous stresses that absorb outgoing waves (5.43)-(5.50).");
  }
}

}  // namespace

void declare_scene_grid(Schema& schema) {
  schema.section("grid",
                 "The background grid of box-shaped cells. Two dimensions: one cell thick.");
  schema.quantities("grid.low", "m", {"0 m", "0 m", "0 m"})
      .exactly(3)
      .in("[-1e6, 1e6]")
      .doc("Lowest corner.");
  schema.quantities("grid.high", "m", {})
      .without_default()
      .exactly(3)
      .in("[-1e6, 1e6]")
      .doc("Highest corner; a whole number of cells away.");
  schema.quantities("grid.cell", "m", {})
      .without_default()
      .exactly(3)
      .or_one_for_all()
      .in("(0, 1e6]")
      .doc("Edges of a cell along x, y and z.");
  declare_interpolation(schema, "grid.interpolation");
  declare_faces(schema);
  schema.section("gravity", "Gravity.");
  schema.quantities("gravity.acceleration", "m/s^2", {"0 m/s^2", "0 m/s^2", "0 m/s^2"})
      .exactly(3)
      .in("[-1e9, 1e9]")
      .doc("Acceleration of everything that moves freely.");
}

void declare_scene_time(Schema& schema) {
  schema.section("time", "Time integration.");
  schema.quantity("time.end", "s", "")
      .without_default()
      .in("(0, 1e6]")
      .doc("End of the simulation.");
  schema.quantity("time.step", "s", "auto")
      .in("(0, 1e6]")
      .or_auto()
      .called("Delta t")
      .doc("Time step; \"auto\" is courant times the critical step.");
  schema.number("time.courant", 0.8)
      .in("(0, 1]")
      .doc(
          "Fraction of the critical step, cell / wave speed, that an \"auto\" step takes at most.");
  schema.section("numerics", "Choices of the scheme; the defaults are the source's.");
  declare_pic_and_damping(schema);
}

void declare_scene_actions(Schema& schema) {
  schema.list("hold",
              "Nodes of the grid that move as prescribed. The force that this takes is in "
              "history.csv.",
              0, false);
  declare_box(schema, "hold", "The box that the nodes lie in.");
  schema.choices("hold.axes", {"x", "y", "z"}, {"x", "y", "z"})
      .doc("Components of the velocity that are held; the others are free.");
  schema.formulas("hold.velocity", "m/s", {"x", "y", "z", "t"}, {"0", "0", "0"})
      .exactly(3)
      .in("[-1e9, 1e9]")
      .doc("Velocity of the nodes, of their place and of time.");

  schema.list("load", "Forces on bodies.", 0, false);
  schema.choice("load.kind", {"force", "traction", "pressure"})
      .doc(
          "A total force or a traction times an area, on the points of a body that lie in a box at "
          "the start, shared by mass; or a pressure on a membrane.");
  schema.reference("load.body", "body").doc("The body that is loaded.");
  declare_box(schema, "load", "The box of the points that carry the force.",
              {{"kind", {"force", "traction"}}});
  schema.formulas("load.force", "N", time_only, {})
      .without_default()
      .exactly(3)
      .only_with("kind", {"force"})
      .doc("Total force.");
  schema.formulas("load.traction", "Pa", time_only, {})
      .without_default()
      .exactly(3)
      .only_with("kind", {"traction"})
      .doc("Force per area.");
  schema.quantity("load.area", "m^2", "")
      .without_default()
      .in("(0, 1e12]")
      .only_with("kind", {"traction"})
      .doc("Area that the traction acts on.");
  schema.formula("load.pressure", "Pa", time_only, "")
      .without_default()
      .only_with("kind", {"pressure"})
      .doc("Pressure along the present normals of the triangles, positive outwards.");
}

void declare_scene_output(Schema& schema) {
  schema.section("output", "What is written into the run directory.");
  schema.quantity("output.history_interval", "s", "auto")
      .in("(0, 1e6]")
      .or_auto()
      .doc("Time between two rows of history.csv; \"auto\" makes 500 of them.");
  schema.quantity("output.fields_interval", "s", "auto")
      .in("(0, 1e6]")
      .or_auto()
      .doc("Time between two frames of fields.h5; \"auto\" makes 20 of them.");
  schema.boolean("output.fields", true).doc("Whether fields are written at all.");
  declare_run(schema);
}

}  // namespace zona::studies
