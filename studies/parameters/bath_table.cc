#include "studies/parameters/bath_table.h"

namespace zona::studies {

const Words<beam::BathModel>& bath_models() {
  static const Words<beam::BathModel> models{{"none", beam::BathModel::none},
                                             {"frequency", beam::BathModel::frequency},
                                             {"per_mode", beam::BathModel::per_mode},
                                             {"constant", beam::BathModel::constant}};
  return models;
}

void declare_bath(Schema& schema) {
  TableKeys<Bath> keys(schema, "bath",
                       "The liquid that the pipette dips into, tip first, while it vibrates. The "
                       "source vibrates it in air.");
  keys.choice("model", &Bath::model, bath_models())
      .doc(
          "None, as the source; the added mass and drag of a cylinder at every frequency (Sader "
          "1998); for each mode those of its own frequency (integrator \"modal\"); or those of one "
          "frequency.");
  keys.quantity("density", &Bath::density, "kg/m^3", "1000 kg/m^3")
      .in("(0, 30000]")
      .doc("Density of the liquid.");
  keys.quantity("viscosity", &Bath::viscosity, "Pa s", "8.9e-4 Pa s")
      .in("(0, 1e3]")
      .doc("Shear viscosity of the liquid; water at 25 degrees Celsius.");
  keys.quantity("immersed_length", &Bath::immersed_length, "m", "1 mm")
      .in("[0, 1]")
      .doc("Immersed length from the tip; the pipette's length or more immerses all of it.");
  keys.quantity("frequency", &Bath::frequency, "Hz", "10 kHz")
      .in("(0, 1e9]")
      .doc("The frequency of model = \"constant\"; the others ignore it.");
  keys.number("drag_coefficient", &Bath::drag_coefficient, 0)
      .in("[0, 100]")
      .called("C_D")
      .doc(
          "Coefficient of a quadratic drag on top of the linear one, rho C_D D |v| v / 2; "
          "integrators \"newmark\" and \"arkode\" only. It is of order one if the tip moves by "
          "more than its diameter.");
  keys.quantity("wall_distance", &Bath::wall_distance, "m", "auto")
      .in("(0, 1]")
      .or_auto()
      .doc(
          "Distance of the pipette's axis from the nearest wall, such as the dish's floor; used "
          "only to warn when it is too near. \"auto\" is far away.");
}

beam::Bath Bath::bath() const {
  beam::Bath bath;
  bath.model = model;
  bath.liquid = {density, viscosity};
  bath.immersed_length = immersed_length;
  bath.frequency = frequency;
  bath.drag_coefficient = drag_coefficient;
  return bath;
}

}  // namespace zona::studies
