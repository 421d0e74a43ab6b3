#include "studies/parameters/step_table.h"

namespace zona::studies {

void declare_step(Schema& schema, const std::string& limit, const std::string& note) {
  TableKeys<StepChoice> keys(schema, "time");
  keys.quantity("step", &StepChoice::step, "s", "auto")
      .in(limit)
      .or_auto()
      .called("Delta t")
      .doc("Time step; \"auto\" is courant times the critical step" + note + ".");
  keys.number("courant", &StepChoice::courant, 0.8)
      .in("(0, 1]")
      .doc(
          "Fraction of the critical step, cell / wave speed, that an \"auto\" step takes at most.");
  keys.number("travel", &StepChoice::travel, 0.05)
      .in("(0, 0.5]")
      .doc(
          "With implicit pressure: part of a cell that the fastest prescribed motion travels in an "
          "\"auto\" step at most.");
}

}  // namespace zona::studies
