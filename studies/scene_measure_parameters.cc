#include "studies/point_values.h"
#include "studies/scene_parameters.h"

namespace zona::studies {

void declare_scene_measures(Schema& schema) {
  schema.list("probe",
              "What is followed in history.csv, a column a component: a point, or the mean of "
              "several.",
              0, true);
  schema.reference("probe.body", "body").doc("The body that is probed.");
  schema.choice("probe.kind", {"point", "mean"})
      .doc("The point that starts nearest to a place, or the mean over the points in a box.");
  schema.quantities("probe.place", "m", {})
      .without_default()
      .exactly(3)
      .in("[-1e6, 1e6]")
      .only_with("kind", {"point"})
      .doc("The place; the summary says which point it is, and how far.");
  declare_box(schema, "probe", "The box of the points.", {{"kind", {"mean"}}});
  schema.choice("probe.membership", {"initial", "current"})
      .only_with("kind", {"mean"})
      .doc("Whether points belong that were in the box at the start, or that are in it now.");
  schema.choices("probe.quantities", quantity_names(), {"displacement", "velocity"})
      .doc(
          "What is followed. Stress, pressure, density, strain and damage are averaged by volume, "
          "all else by mass. The strain is the largest principal one of a membrane; the energy is "
          "specific, internal of a fluid, elastic of a solid or membrane.");

  schema.list("profile",
              "Averages over slices along an axis, at chosen times, in profiles.csv: density, "
              "velocity, stress, pressure and energy.",
              0, true);
  schema.choice("profile.axis", {"x", "y", "z"}).doc("The axis that the slices stand across.");
  schema.quantity("profile.width", "m", "auto")
      .in("(0, 1e6]")
      .or_auto()
      .doc("Thickness of a slice; \"auto\" is `cells` cells. Slices start at `low`.");
  schema.integer("profile.cells", 1)
      .in("[1, 1000000]")
      .doc("Cells that an \"auto\" slice is thick.");
  schema.references("profile.bodies", "body")
      .auto_by_default()
      .doc("Bodies whose points are averaged together; \"auto\" takes all that are not rigid.");
  declare_box(schema, "profile", "Only points in this box count.");
  schema.choice("profile.membership", {"initial", "current"})
      .doc(
          "Whether a slice holds the points that started in it, wherever they are, as in the "
          "source's averages of points initialised in a cell; or those that are in it now.");
  schema.quantities("profile.times", "s", {})
      .in("[0, 1e6]")
      .auto_by_default()
      .doc("When; the step that is nearest counts. \"auto\" is the end.");
}

}  // namespace zona::studies
