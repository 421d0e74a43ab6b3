#include "studies/measures/section_table.h"

#include "studies/parameters/axes.h"

namespace zona::studies {

void declare_sections(Schema& schema, const MeasuredBodies& bodies) {
  schema.list("section",
              "Averages over the cells that a plane cuts, at chosen times, in sections.csv: as of "
              "profiles." +
                  bodies.note,
              0, true);
  TableKeys<SectionTable> keys(schema, "section");
  declare_averaged_bodies(keys, bodies);
  keys.choice("normal", &SectionTable::normal, kAxisNames, kAxisNames.back().value)
      .doc("The axis that the plane stands across.");
  keys.quantity("place", &SectionTable::place, "m", "")
      .without_default()
      .in("[-1e6, 1e6]")
      .doc("Where the plane cuts that axis. Points in the layer of cells around it count.");
  declare_average_times(keys);
  schema.check_each(keys.section(), [=](const Table& section, const Complain& complain) {
    check_averages<SectionTable>(section, complain, bodies);
  });
}

}  // namespace zona::studies
