#include "studies/kinds/piercing/beam_drive.h"

#include "studies/parameters/bath_table.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/beam_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pulse_table.h"

namespace zona::studies {

void declare_beam_drive(Schema& schema) {
  schema.section("beam", "The pipette as a beam, which moves the tip when motion.kind = \"beam\".");
  declare_beam(schema, "beam", 80);
  declare_beam_integration(schema, "beam", IntegratorName::modal);
  declare_columns(schema);
  declare_bath(schema);
  schema.section("pulse", "The motion of the beam's support, when motion.kind = \"beam\".");
  declare_pulse(schema, false);
  declare_pulse_duration(schema);
}

}  // namespace zona::studies
