#include "studies/kinds/piercing/measures.h"

#include "studies/kinds/piercing/scheme_tables.h"
#include "studies/measures/measure_parameters.h"

namespace zona::studies {

namespace {

Substance substance_of(const Configuration& study, const std::string& name) {
  if (name == "zona") return {"membrane", study.choice("zona.law")};
  return {name == "cytoplasm" || name == "medium" ? "liquid" : "rigid", ""};
}

void declare_probed(Schema& schema, const std::string& key) {
  schema.choice(key, {"zona", "cytoplasm", "medium", "pipette", "plate"})
      .doc("The body that is probed.");
}

void declare_averaged(Schema& schema, const std::string& key) {
  schema.choices(key, {"zona", "cytoplasm", "medium"}, {"cytoplasm", "medium"})
      .doc("Bodies whose points are averaged together.");
}

void check_plate(const Table& probe, const Complain& complain) {
  if (probe.text("body") == "plate" && !probe.study().boolean("plate.enabled")) {
    complain("body", "there is no plate: plate.enabled = false");
  }
}

}  // namespace

void declare_piercing_measures(Schema& schema) {
  declare_measures(schema, {" Places count from the middle of the egg.", declare_probed,
                            declare_averaged, substance_of, simulation_end});
  schema.check_each("probe", check_plate);
}

}  // namespace zona::studies
