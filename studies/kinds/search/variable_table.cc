#include "studies/kinds/search/variable_table.h"

namespace zona::studies::search {

namespace {

const Words<Scale> kScales{{"linear", Scale::linear}, {"logarithmic", Scale::logarithmic}};

template <class T>
void declare_varied(TableKeys<T>& keys) {
  keys.text("key", &Varied::key, "pulse.duration")
      .without_default()
      .doc("A key of the study with one value, e.g. \"pulse.duration\" or \"fill.fluid\".");
  keys.anything("range", &Varied::range)
      .doc("The lowest and the highest value, written as in the study.");
  keys.anything("values", &Varied::values).doc("The values, instead of a range.");
  keys.choice("scale", &Varied::scale, kScales).doc("Scale on which a range is sampled evenly.");
}

}  // namespace

void declare_variables(Schema& schema) {
  schema.list("variable", "Inputs to choose: a key of the study with its values or its range.", 1,
              false);
  TableKeys<Variable> keys(schema, "variable");
  declare_varied(keys);
}

void declare_uncertain(Schema& schema) {
  schema.list("uncertain",
              "Uncertain inputs, which are sampled: a key of the study with its range.", 0, false);
  TableKeys<Uncertain> keys(schema, "uncertain");
  declare_varied(keys);
  keys.text("source", &Uncertain::source, "")
      .doc("Where the range comes from; the report repeats it.");
}

}  // namespace zona::studies::search
