#pragma once

#include <optional>

#include "studies/input/table_keys.h"
#include "studies/kinds/search/measure.h"

namespace zona::studies::search {

/// A [[limit]], as written: with units of its measure.
struct LimitTable {
  const Measure* measure;
  std::optional<TomlValue> at_least;
  std::optional<TomlValue> at_most;
};

/// The list [[limit]]. Complains of limits without a bound.
void declare_limits(Schema& schema);

}  // namespace zona::studies::search
