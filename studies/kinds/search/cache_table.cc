#include "studies/kinds/search/cache_table.h"

namespace zona::studies::search {

void declare_cache(Schema& schema) {
  TableKeys<Cache> keys(schema, "run");
  keys.text("cache", &Cache::folder, "")
      .doc(
          "Folder of the piercings' results, by what decides them, from the working directory; "
          "empty: `cases` in the run's directory. Searches and processes that share one do nothing "
          "twice.");
}

}  // namespace zona::studies::search
