#include "studies/kinds/piercing/plate_table.h"

namespace zona::studies {

void declare_plate(Schema& schema) {
  TableKeys<Plate> keys(schema, "plate",
                        "The holding pipette, a square plate at rest behind the oocyte.");
  keys.boolean("enabled", &Plate::enabled, true).doc("Whether there is a plate.");
  keys.quantity("side", &Plate::side, "m", "72 um")
      .in("(0, 0.1]")
      .doc("Side length (5.4: 72 um with cells of 4 and 6 um, 70 um with 5 um).");
  keys.integer("thickness_cells", &Plate::thickness_cells, 3)
      .in("[1, 1000]")
      .doc("Thickness in cells (5.4).");
  keys.quantity("density", &Plate::density, "kg/m^3", "2300 kg/m^3")
      .in("(0, 30000]")
      .doc("Density of the glass (5.4).");
}

}  // namespace zona::studies
