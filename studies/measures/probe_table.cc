#include "studies/measures/probe_table.h"

#include <fmt/format.h>

namespace zona::studies {

namespace {

const Words<ProbeKind> kProbeKinds{{"point", ProbeKind::point}, {"mean", ProbeKind::mean}};

Words<const PointQuantity*> quantity_words() {
  Words<const PointQuantity*> words;
  for (const PointQuantity& quantity : point_quantities())
    words.push_back({quantity.name.c_str(), &quantity});
  return words;
}

void check_quantities(const Table& probe, const Complain& complain, const MeasuredBodies& bodies) {
  const std::string name = probe.value(&ProbeTable::body);
  const Substance substance = bodies.substance(probe.study(), name);
  for (const PointQuantity* quantity : probe.value(&ProbeTable::quantities)) {
    if (substance.has(quantity->of)) continue;
    complain(probe.leaf(&ProbeTable::quantities),
             fmt::format("the points of {} ({}) have no {}; leave it out", name, substance.text(),
                         quantity->name));
  }
}

}  // namespace

void declare_probes(Schema& schema, const MeasuredBodies& bodies) {
  schema.list("probe",
              "What is followed in history.csv, a column a component: a point, or the mean of "
              "several." +
                  bodies.note,
              0, true);
  TableKeys<ProbeTable> keys(schema, "probe");
  keys.declared("body", &ProbeTable::body, bodies.declare_probed);
  keys.choice("kind", &ProbeTable::kind, kProbeKinds)
      .doc("The point that starts nearest to a place, or the mean over the points in a box.");
  keys.quantities("place", &ProbeTable::place, "m", {})
      .without_default()
      .exactly(3)
      .in("[-1e6, 1e6]")
      .only_where(keys.is(&ProbeTable::kind, kProbeKinds, {ProbeKind::point}))
      .doc("The place; the summary says which point it is, and how far.");
  const Condition mean = keys.is(&ProbeTable::kind, kProbeKinds, {ProbeKind::mean});
  declare_box(keys, "The box of the points.", {mean});
  keys.choice("membership", &ProbeTable::membership, kMemberships)
      .only_where(mean)
      .doc("Whether points belong that were in the box at the start, or that are in it now.");
  keys.choices("quantities", &ProbeTable::quantities, quantity_words(),
               {"displacement", "velocity"})
      .doc(
          "What is followed. Stress, pressure, density, strain and damage are averaged by volume, "
          "all else by mass. The strain is the largest principal one of a membrane; the energy is "
          "specific, internal of a fluid, elastic of a solid or membrane.");
  schema.check_each(keys.section(), [=](const Table& probe, const Complain& complain) {
    check_box<ProbeTable>(probe, complain, false);
    check_quantities(probe, complain, bodies);
  });
}

}  // namespace zona::studies
