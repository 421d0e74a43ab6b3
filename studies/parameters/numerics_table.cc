#include "studies/parameters/numerics_table.h"

namespace zona::studies {

const Words<mpm::Interpolation>& interpolations() {
  static const Words<mpm::Interpolation> words{{"linear", mpm::Interpolation::linear},
                                               {"quadratic", mpm::Interpolation::quadratic}};
  return words;
}

const Words<mpm::EnergyIncrement>& energy_increments() {
  static const Words<mpm::EnergyIncrement> words{
      {"end_pressure", mpm::EnergyIncrement::end_pressure},
      {"mean_pressure", mpm::EnergyIncrement::mean_pressure}};
  return words;
}

const char* const kInterpolationText =
    "Shape functions: trilinear as the source (3.7)-(3.11), or quadratic B-splines, whose "
    "gradients do not jump where points cross cells.";
const char* const kAverageVolumeText =
    "Average the volumetric strain rate, and the pressure that acts, over the points of each cell, "
    "which reduces noise in the pressure of single points.";
const char* const kEnergyIncrementText =
    "Which pressure does the work of a step in (4.40): that at its end, as in the source, which "
    "heats a fluid that is compressed and expanded; or the mean of both ends.";

void declare_numerics(Schema& schema) {
  TableKeys<mpm::Numerics> keys(schema, "numerics");
  keys.number("pic", &mpm::Numerics::pic, 0)
      .in("[0, 1]")
      .doc(
          "Fraction of PIC in the points' velocity: 0 is FLIP (3.37), 1 takes all of it from the "
          "grid and damps motions that the grid does not resolve.");
  keys.choice("pressure", &mpm::Numerics::implicit_pressure,
              Words<bool>{{"explicit", false}, {"implicit", true}}, false)
      .doc(
          "Pressure of the fluids: explicit, as in the source, in steps that wait for sound; or "
          "implicit, in steps as long as motion, membranes, solids and viscosity allow, with "
          "linear "
          "shape functions.");
  keys.number("pressure_tolerance", &mpm::Numerics::pressure_tolerance, 1e-3)
      .in("[1e-10, 0.1]")
      .doc(
          "Residual of the implicit pressure, as a part of the expansion that the pressure "
          "prevents.");
  keys.number("damping", &mpm::Numerics::damping, 0)
      .in("[0, 1)")
      .doc("Local non-viscous damping of the nodal forces, for problems that come to rest.");
}

}  // namespace zona::studies
