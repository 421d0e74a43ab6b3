#include "studies/parameters/output_table.h"

namespace zona::studies {

void declare_output(Schema& schema, const IntervalKey& history, const IntervalKey& fields) {
  TableKeys<Output> keys(schema, "output", "What is written into the run directory.");
  const auto finish = [](Parameter& parameter, const IntervalKey& key, const std::string& text) {
    parameter.in(key.limit).doc(text + key.note);
    if (key.preset == "auto") parameter.or_auto();
  };
  finish(keys.quantity("history_interval", &Output::history_interval, "s", history.preset), history,
         "Time between two rows of history.csv");
  finish(keys.quantity("fields_interval", &Output::fields_interval, "s", fields.preset), fields,
         "Time between two frames of fields.h5");
  keys.boolean("fields", &Output::fields, true).doc("Whether fields are written at all.");
}

}  // namespace zona::studies
