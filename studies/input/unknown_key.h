#pragma once

#include <string>
#include <vector>

#include "studies/input/schema.h"
#include "studies/input/toml_document.h"

namespace zona::studies {

/// What to say about an entry that a schema does not declare: what it may have meant, or which of
/// the other schemas it belongs to.
std::string unknown_key_message(const Schema& schema, const TomlEntry& entry,
                                const std::vector<const Schema*>& schemas);

/// The table without keys of its own that an unknown key stands in, as far as one message is enough
/// for all its keys: an item of a list that is none, "grid.0", or that does not exist, "body.lft".
std::string unknown_table(const Schema& schema, const std::string& key);

}  // namespace zona::studies
