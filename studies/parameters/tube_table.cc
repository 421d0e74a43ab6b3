#include "studies/parameters/tube_table.h"

#include <fmt/format.h>

namespace zona::studies {

namespace {

void check_bore(const Configuration& study, const Complain& complain) {
  const double outer = study.value(&GlassTube::outer_diameter);
  const double inner = study.value(&GlassTube::inner_diameter);
  if (inner < outer) return;
  const std::string outer_key = study.key(&GlassTube::outer_diameter);
  const std::string inner_key = study.key(&GlassTube::inner_diameter);
  const bool only_outer_given = study.is_default(inner_key) && !study.is_default(outer_key);
  complain(only_outer_given ? outer_key : inner_key,
           fmt::format("the bore of {:g} um is not narrower than the pipette of {:g} um; make {} "
                       "smaller than {}",
                       inner * 1e6, outer * 1e6, inner_key, outer_key));
}

}  // namespace

void declare_tube(Schema& schema, const std::string& section) {
  TableKeys<GlassTube> keys(schema, section);
  keys.quantity("outer_diameter", &GlassTube::outer_diameter, "m", "10 um")
      .in("(0, 0.01]")
      .doc(
          "Outer diameter of the injection pipette (5.4; with the bore it gives EI of Table 5.5).");
  keys.quantity("inner_diameter", &GlassTube::inner_diameter, "m", "8 um")
      .in("[0, 0.01]")
      .doc("Diameter of the bore, which the fluid fills; zero for a solid rod (5.4).");
  keys.quantity("density", &GlassTube::density, "kg/m^3", "2300 kg/m^3")
      .in("(0, 30000]")
      .doc("Density of the glass (5.4); with the fluid it gives the mass per length of Table 5.5.");
  schema.check(check_bore);
}

}  // namespace zona::studies
