#pragma once

#include <string>
#include <vector>

#include "studies/input/table_keys.h"

namespace zona::studies::search {

/// Scale on which a range is sampled evenly.
enum class Scale { linear, logarithmic };

/// A key of the piercing that is varied, with its values or its range as that study has them.
struct Varied {
  std::string key;
  std::vector<TomlValue> range;   ///< lowest and highest value; empty: `values`
  std::vector<TomlValue> values;  ///< empty: `range`
  Scale scale;
};

/// A [[variable]], which a search chooses.
struct Variable : Varied {};

/// An [[uncertain]] input, which is sampled.
struct Uncertain : Varied {
  std::string source;  ///< where the range comes from
};

/// The lists [[variable]] and [[uncertain]].
void declare_variables(Schema& schema);
void declare_uncertain(Schema& schema);

}  // namespace zona::studies::search
