#include "studies/kinds/scene/hold_table.h"

#include "studies/parameters/axes.h"

namespace zona::studies {

void declare_holds(Schema& schema) {
  schema.list("hold",
              "Nodes of the grid with a prescribed velocity. Their force is in history.csv.", 0,
              false);
  TableKeys<Hold> keys(schema, "hold");
  declare_box(keys, "The box that the nodes lie in.");
  keys.choices("axes", &Hold::axes, kAxisNames, texts_of(kAxisNames))
      .doc("Components of the velocity that are held; the others are free.");
  keys.formulas("velocity", &Hold::velocity, "m/s", {"x", "y", "z", "t"}, {"0", "0", "0"})
      .exactly(3)
      .in("[-1e9, 1e9]")
      .doc("Velocity of the nodes, a function of place and time.");
  schema.check_each(keys.section(), [](const Table& hold, const Complain& complain) {
    check_box<Hold>(hold, complain, true);
  });
}

}  // namespace zona::studies
