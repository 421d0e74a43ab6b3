#include "studies/kinds/search/limit_table.h"

namespace zona::studies::search {

namespace {

std::string measure_list() {
  std::string text;
  for (const Measure& measure : measures())
    text += " " + measure.name + ": " + measure.documentation;
  return text;
}

void check_bounds(const Table& limit, const Complain& complain) {
  if (limit.value(&LimitTable::at_least) || limit.value(&LimitTable::at_most)) return;
  complain(limit.leaf(&LimitTable::at_least), "is missing, and so is at_most; give one or both");
}

}  // namespace

void declare_limits(Schema& schema) {
  schema.list("limit", "Limits that a design must keep.", 0, false);
  TableKeys<LimitTable> keys(schema, "limit");
  keys.choice("measure", &LimitTable::measure, measure_words())
      .without_default()
      .doc("Measure of the tip or of the piercing." + measure_list());
  keys.bound("at_least", &LimitTable::at_least).doc("Lowest value, with its unit.");
  keys.bound("at_most", &LimitTable::at_most).doc("Highest value, with its unit.");
  schema.check_each(keys.section(), check_bounds);
}

}  // namespace zona::studies::search
