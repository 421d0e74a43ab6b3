#include "studies/parameters/numerics_parameters.h"

namespace zona::studies {

void declare_interpolation(Schema& schema, const std::string& key) {
  schema.choice(key, {"linear", "quadratic"})
      .doc(
          "Shape functions: trilinear as the source (3.7)-(3.11), or quadratic B-splines, whose "
          "gradients do not jump where points cross cells.");
}

Parameter& declare_volume_average(Schema& schema, const std::string& key) {
  return schema.boolean(key, false)
      .doc(
          "Average the volumetric strain rate, and the pressure that acts, over the points of each "
          "cell: against noise in the pressure of single points.");
}

Parameter& declare_energy_increment(Schema& schema, const std::string& key) {
  return schema.choice(key, {"end_pressure", "mean_pressure"})
      .doc(
          "Which pressure does the work of a step in (4.40): that at its end, as in the source, "
          "which heats a fluid that is compressed and expanded; or the mean of both ends.");
}

void declare_pic_and_damping(Schema& schema) {
  schema.number("numerics.pic", 0)
      .in("[0, 1]")
      .doc(
          "Fraction of PIC in the points' velocity: 0 is FLIP (3.37), 1 takes all of it from the "
          "grid and damps what the grid does not see.");
  schema.number("numerics.damping", 0)
      .in("[0, 1)")
      .doc("Local non-viscous damping of the nodal forces, for problems that are to come to rest.");
}

mpm::Interpolation interpolation_of(const std::string& name) {
  return name == "quadratic" ? mpm::Interpolation::quadratic : mpm::Interpolation::linear;
}

mpm::EnergyIncrement energy_increment_of(const std::string& name) {
  return name == "mean_pressure" ? mpm::EnergyIncrement::mean_pressure
                                 : mpm::EnergyIncrement::end_pressure;
}

mpm::Numerics numerics_from(const Configuration& study) {
  return {study.number("numerics.pic"), study.number("numerics.damping")};
}

}  // namespace zona::studies
