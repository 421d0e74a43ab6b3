#include "studies/kinds/scene/fluid_table.h"

#include "studies/parameters/numerics_table.h"

namespace zona::studies {

namespace {

void declare_state(TableKeys<SceneFluid>& keys, const Condition& gas, const Condition& liquid) {
  keys.number("gamma", &SceneFluid::gamma, 1.4)
      .in("(1, 10]")
      .called("gamma")
      .only_where(gas)
      .doc("Ratio of heat capacities of an ideal gas (4.31).");
  keys.number("grueneisen", &SceneFluid::grueneisen, 4)
      .in("(0, 100]")
      .called("Gamma")
      .only_where(liquid)
      .doc("Parameter of the stiffened-gas equation of state (5.1); water by default.");
  keys.quantity("p_infinity", &SceneFluid::p_infinity, "Pa", "6.13e8 Pa")
      .in("(0, 1e15]")
      .called("P_inf")
      .only_where(liquid)
      .doc("Stiffness pressure of the stiffened-gas equation of state (5.1); water by default.");
}

}  // namespace

mpm::FluidProperties SceneFluid::properties() const {
  mpm::FluidProperties p{};
  p.state =
      gamma ? mpm::StiffenedGas::ideal_gas(*gamma) : mpm::StiffenedGas{grueneisen, p_infinity};
  p.shear_viscosity = viscosity;
  p.energy_increment = energy_increment;
  p.artificial_viscosity = {artificial_viscosity_quadratic, artificial_viscosity_linear};
  return p;
}

void declare_scene_fluid(Schema& schema, const std::string& section, const Condition& gas,
                         const Condition& liquid) {
  Condition either = gas;
  either.values.insert(either.values.end(), liquid.values.begin(), liquid.values.end());
  TableKeys<SceneFluid> keys(schema, section);
  keys.formula("pressure", &SceneFluid::pressure, "Pa", {"x", "y", "z"}, "0 Pa")
      .in("[-1e15, 1e15]")
      .only_where(either)
      .doc("Initial pressure. A gas needs a positive one.");
  declare_state(keys, gas, liquid);
  keys.quantity("viscosity", &SceneFluid::viscosity, "Pa s", "0 Pa s")
      .in("[0, 1e9]")
      .called("mu")
      .only_where(either)
      .doc("Shear viscosity; Stokes' condition holds (4.28).");
  keys.choice("energy_increment", &SceneFluid::energy_increment, energy_increments())
      .only_where(either)
      .doc(kEnergyIncrementText);
  keys.number("artificial_viscosity_quadratic", &SceneFluid::artificial_viscosity_quadratic, 0)
      .in("[0, 100]")
      .called("c_0")
      .only_where(either)
      .doc("Quadratic coefficient of the artificial viscosity (4.45).");
  keys.number("artificial_viscosity_linear", &SceneFluid::artificial_viscosity_linear, 0)
      .in("[0, 100]")
      .called("c_1")
      .only_where(either)
      .doc("Linear coefficient of the artificial viscosity (4.45).");
}

}  // namespace zona::studies
