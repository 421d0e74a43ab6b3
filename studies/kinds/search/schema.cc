#include "studies/kinds/search/schema.h"

#include "studies/kinds/search/cache_table.h"
#include "studies/kinds/search/limit_table.h"
#include "studies/kinds/search/search_table.h"
#include "studies/kinds/search/variable_table.h"
#include "studies/parameters/run_table.h"

namespace zona::studies {

namespace {

Schema make_schema() {
  Schema schema("search",
                "Which fluid, geometry and pulse pierce with least damage: beams by the thousand, "
                "then piercings of the best, with uncertain inputs.");
  search::declare_search(schema);
  search::declare_variables(schema);
  search::declare_uncertain(schema);
  search::declare_limits(schema);
  schema.section("run", "Settings of the program, which do not change the results.");
  declare_threads_and_log(schema);
  search::declare_cache(schema);
  return schema;
}

}  // namespace

const Schema& search_schema() {
  static const Schema schema = make_schema();
  return schema;
}

}  // namespace zona::studies
