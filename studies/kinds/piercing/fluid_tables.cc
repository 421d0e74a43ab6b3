#include "studies/kinds/piercing/fluid_tables.h"

namespace zona::studies {

namespace {

/// Only p_infinity and the number of points differ.
template <class T>
void declare_fluid(TableKeys<T> keys, const std::string& p_infinity, long points_per_cell) {
  keys.quantity("density", &FluidKeys::density, "kg/m^3", "1000 kg/m^3")
      .in("(0, 30000]")
      .called("rho")
      .doc("Initial density (5.4).");
  keys.number("grueneisen", &FluidKeys::grueneisen, 4)
      .in("(0, 100]")
      .called("Gamma")
      .doc("Fit parameter of the stiffened-gas equation of state (Table 5.3).");
  keys.quantity("p_infinity", &FluidKeys::p_infinity, "Pa", p_infinity)
      .in("(0, 1e12]")
      .called("P_inf")
      .doc("Stiffness pressure of the stiffened-gas equation of state (Table 5.3).");
  keys.quantity("viscosity", &FluidKeys::viscosity, "Pa s", "8.9e-4 Pa s")
      .in("[0, 1e3]")
      .called("mu")
      .doc("Shear viscosity; Stokes' condition holds (5.4).");
  keys.integer("points_per_cell", &FluidKeys::points_per_cell, points_per_cell)
      .one_of({1, 8, 27, 64})
      .doc(
          "Material points that a full cell starts with, the cube of the number along an edge "
          "(5.4).");
  keys.number("artificial_viscosity_quadratic", &FluidKeys::artificial_viscosity_quadratic, 0)
      .in("[0, 100]")
      .called("c_0")
      .doc(
          "Quadratic coefficient of the artificial viscosity (4.45); the source uses none in "
          "piercings.");
  keys.number("artificial_viscosity_linear", &FluidKeys::artificial_viscosity_linear, 0)
      .in("[0, 100]")
      .called("c_1")
      .doc(
          "Linear coefficient of the artificial viscosity (4.45); the source uses none in "
          "piercings.");
}

}  // namespace

void declare_fluids(Schema& schema) {
  declare_fluid(TableKeys<Cytoplasm>(schema, "cytoplasm", "The fluid in the zona."), "2.12e8 Pa",
                27);
  declare_fluid(TableKeys<Medium>(schema, "medium", "The fluid around the zona."), "6.13e8 Pa", 1);
}

mpm::FluidProperties FluidKeys::properties(mpm::EnergyIncrement energy_increment) const {
  mpm::FluidProperties fluid{};
  fluid.density = density;
  fluid.state = {grueneisen, p_infinity};
  fluid.shear_viscosity = viscosity;
  fluid.energy_increment = energy_increment;
  fluid.artificial_viscosity = {artificial_viscosity_quadratic, artificial_viscosity_linear};
  return fluid;
}

}  // namespace zona::studies
