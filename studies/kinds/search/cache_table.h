#pragma once

#include <string>

#include "studies/input/table_keys.h"

namespace zona::studies::search {

/// Where the results of piercings are kept.
struct Cache {
  std::string folder;  ///< relative to the working directory; empty: in the run's directory
};

/// The key in [run], which must be open.
void declare_cache(Schema& schema);

}  // namespace zona::studies::search
