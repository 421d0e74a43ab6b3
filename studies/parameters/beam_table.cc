#include "studies/parameters/beam_table.h"

#include <fmt/format.h>

namespace zona::studies {

namespace {

void check_profile(const Configuration& study, const Complain& complain) {
  if (study.value(&Beam::profile).empty()) return;
  for (const auto diameter : {&Beam::shoulder_outer_diameter, &Beam::shoulder_inner_diameter}) {
    if (!study.value(diameter)) continue;
    complain(study.key(diameter),
             fmt::format(
                 "is given together with {}, which already gives the diameters; remove one of them",
                 study.key(&Beam::profile)));
  }
}

void declare_glass(TableKeys<Beam>& keys, long elements) {
  keys.quantity("length", &Beam::length, "m", "10 mm")
      .in("(0, 1]")
      .called("L")
      .doc(
          "Free length between support and tip. The source does not give it; Tables 5.5 and 5.6 "
          "fix it.");
  keys.quantity("youngs_modulus", &Beam::youngs_modulus, "Pa", "63.44 GPa")
      .in("(0, 1e13]")
      .called("E")
      .doc("Young's modulus of the glass; gives EI = 183.86e-13 Pa m^4 of Table 5.5.");
  keys.integer("elements", &Beam::elements, elements)
      .in("[1, 1000]")
      .doc(
          "Number of cubic elements of the beam, and of the rod along it. The source's twenty "
          "(5.5) overestimate the amplitude of the mercury-filled tip after 60 us by a third; "
          "eighty are good to 1 % of the peak.");
  keys.quantity("rayleigh_alpha", &Beam::rayleigh_alpha, "1/s", "0 1/s")
      .in("[0, 1e9]")
      .doc("Mass-proportional Rayleigh damping; the source has none.");
  keys.quantity("rayleigh_beta", &Beam::rayleigh_beta, "s", "0 s")
      .in("[0, 1]")
      .doc("Stiffness-proportional Rayleigh damping; the source has none.");
  keys.number("loss_factor", &Beam::loss_factor, 0)
      .in("[0, 10]")
      .doc(
          "Loss factor tan(delta) of the glass, the same at all frequencies; the source has none.");
  keys.quantity("loss_frequency", &Beam::loss_frequency, "Hz", "10 kHz")
      .in("(0, 1e9]")
      .doc("Frequency at which youngs_modulus is the storage modulus of a lossy glass.");
}

void declare_taper(TableKeys<Beam>& keys) {
  keys.quantity("shoulder_outer_diameter", &Beam::shoulder_outer_diameter, "m", "auto")
      .in("(0, 0.01]")
      .or_auto()
      .doc(
          "Outer diameter at the support, from which the pipette tapers evenly to the tip; "
          "\"auto\" is the tip's.");
  keys.quantity("shoulder_inner_diameter", &Beam::shoulder_inner_diameter, "m", "auto")
      .in("[0, 0.01]")
      .or_auto()
      .doc("Inner diameter at the support; \"auto\" keeps the ratio to the outer one of the tip.");
  keys.file("profile", &Beam::profile, "")
      .doc(
          "CSV file of diameters along the axis instead of an even taper, with the headings "
          "`distance [mm], outer [um], inner [um]` (any units of length); distances count from the "
          "tip, where the diameters must be those of [pipette].");
}

}  // namespace

void declare_beam(Schema& schema, const std::string& section, long elements) {
  TableKeys<Beam> keys(schema, section);
  declare_glass(keys, elements);
  declare_taper(keys);
  schema.check(check_profile);
}

}  // namespace zona::studies
