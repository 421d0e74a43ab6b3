#include "studies/kinds/piercing/measures.h"

#include "studies/input/table_keys.h"
#include "studies/kinds/piercing/plate_table.h"
#include "studies/kinds/piercing/scheme_tables.h"
#include "studies/kinds/piercing/zona_table.h"
#include "studies/measures/measured_bodies.h"
#include "studies/measures/probe_table.h"

namespace zona::studies {

namespace {

enum class PiercingBody { zona, cytoplasm, medium, pipette, plate };

const Words<PiercingBody> kBodies{{"zona", PiercingBody::zona},
                                  {"cytoplasm", PiercingBody::cytoplasm},
                                  {"medium", PiercingBody::medium},
                                  {"pipette", PiercingBody::pipette},
                                  {"plate", PiercingBody::plate}};

LawName law_of(ZonaLaw law) {
  switch (law) {
    case ZonaLaw::elastic:
      return LawName::elastic;
    case ZonaLaw::elastodamage:
      return LawName::elastodamage;
    case ZonaLaw::decohesion:
      break;
  }
  return LawName::decohesion;
}

Substance substance_of(const Configuration& study, const std::string& name) {
  switch (value_of(kBodies, name)) {
    case PiercingBody::zona:
      return {MaterialName::membrane, law_of(study.value(&Zona::law))};
    case PiercingBody::cytoplasm:
    case PiercingBody::medium:
      return {MaterialName::liquid, {}};
    case PiercingBody::pipette:
    case PiercingBody::plate:
      break;
  }
  return {MaterialName::rigid, {}};
}

std::vector<std::string> names_of(const std::vector<PiercingBody>& bodies) {
  std::vector<std::string> names;
  for (const PiercingBody body : bodies) names.push_back(word_for(kBodies, body));
  return names;
}

Parameter& declare_probed(Schema& schema, const std::string& key) {
  return schema.choice(key, texts_of(kBodies)).doc("The probed body.");
}

Parameter& declare_averaged(Schema& schema, const std::string& key) {
  return schema
      .choices(key, names_of({PiercingBody::zona, PiercingBody::cytoplasm, PiercingBody::medium}),
               names_of({PiercingBody::cytoplasm, PiercingBody::medium}))
      .doc("Bodies whose points are averaged together.");
}

void check_plate_exists(const Table& probe, const Complain& complain) {
  const Configuration& study = probe.study();
  const PiercingBody body = value_of(kBodies, probe.value(&ProbeTable::body));
  if (body != PiercingBody::plate || study.value(&Plate::enabled)) return;
  complain(probe.leaf(&ProbeTable::body),
           "there is no plate: " + study.key(&Plate::enabled) + " = false");
}

}  // namespace

void declare_piercing_measures(Schema& schema) {
  declare_measures(schema, {" Places count from the middle of the egg.", declare_probed,
                            declare_averaged, substance_of, simulation_end});
  schema.check_each(schema.binding<ProbeTable>().section, check_plate_exists);
}

}  // namespace zona::studies
