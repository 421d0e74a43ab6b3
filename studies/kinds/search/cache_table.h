#pragma once

#include <string>

#include "studies/input/table_keys.h"

namespace zona::studies::search {

/// Cache of the results of piercings.
struct Cache {
  std::string folder;  ///< relative to the working directory; empty: in the run's directory
};

/// The key in [run], which must be open.
void declare_cache(Schema& schema);

}  // namespace zona::studies::search
