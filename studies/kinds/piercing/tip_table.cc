#include "studies/kinds/piercing/tip_table.h"

namespace zona::studies {

namespace {

const Words<mpm::Drive> kDrives{{"points", mpm::Drive::points}, {"nodes", mpm::Drive::nodes}};

}  // namespace

void declare_tip(Schema& schema, const std::string& point_density) {
  TableKeys<Tip> keys(schema, "pipette",
                      "The tip of the injection pipette, a tube that moves as prescribed.");
  declare_tube(schema, keys.section());
  keys.quantity("tip_length", &Tip::tip_length, "m", "15 um")
      .in("(0, 0.01]")
      .doc("Length of the tip that the simulation holds (5.4).");
  keys.integers("points", &Tip::points, {2, 60, 45})
      .exactly(3)
      .in("[1, 10000]")
      .doc("Points through the wall, around and along the tip; 5400 in all (5.4).");
  keys.quantity("point_density", &Tip::point_density, "kg/m^3", point_density)
      .in("(0, 1e6]")
      .or_auto()
      .doc(
          "Density of the tip's points. \"auto\" spreads the fluid of the bore evenly over the "
          "glass: 26478 kg/m^3 with mercury, where the source states 26441 (5.4). The motion is "
          "prescribed, so this mass only sets how firmly the tip holds the grid around it: "
          "comparisons keep the source's value for every fill, so that a light fill does not seem "
          "to slip.");
  keys.choice("drive", &Tip::drive, kDrives)
      .doc(
          "Where the motion is prescribed: at the pipette's points, which the grid mixes with "
          "their surroundings by mass (the source), or at every node that they touch, which is "
          "much harsher.");
}

double Tip::density_with(double fluid_density, const GlassTube& tube) const {
  if (point_density) return *point_density;
  const double outer = tube.outer_diameter;
  const double inner = tube.inner_diameter;
  const double bore_per_glass = inner * inner / (outer * outer - inner * inner);
  return tube.density + fluid_density * bore_per_glass;
}

}  // namespace zona::studies
