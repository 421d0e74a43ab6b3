#pragma once

#include <string>
#include <vector>

#include "studies/input/schema.h"
#include "studies/input/toml_document.h"

namespace zona::studies {

/// Message about an entry that the schema does not declare, with the key that was probably meant or
/// the other schema that it belongs to.
std::string unknown_key_message(const Schema& schema, const TomlEntry& entry,
                                const std::vector<const Schema*>& schemas);

/// The unknown table of a key, if one message can cover all its keys: an item of a table that is no
/// list, "grid.0", or an item that does not exist, "body.lft".
std::string unknown_table(const Schema& schema, const std::string& key);

}  // namespace zona::studies
