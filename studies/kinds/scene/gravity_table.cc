#include "studies/kinds/scene/gravity_table.h"

namespace zona::studies {

void declare_gravity(Schema& schema) {
  TableKeys<Gravity> keys(schema, "gravity", "Gravity.");
  keys.quantities("acceleration", &Gravity::acceleration, "m/s^2",
                  {"0 m/s^2", "0 m/s^2", "0 m/s^2"})
      .exactly(3)
      .in("[-1e9, 1e9]")
      .doc("Acceleration of everything that moves freely.");
}

}  // namespace zona::studies
