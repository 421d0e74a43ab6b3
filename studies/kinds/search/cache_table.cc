#include "studies/kinds/search/cache_table.h"

namespace zona::studies::search {

void declare_cache(Schema& schema) {
  TableKeys<Cache> keys(schema, "run");
  keys.text("cache", &Cache::folder, "")
      .doc(
          "Folder that keeps the results of piercings by their inputs, relative to the working "
          "directory; empty: `cases` in the run's directory. Searches and processes that share it "
          "compute nothing twice.");
}

}  // namespace zona::studies::search
