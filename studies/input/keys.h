#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace zona::studies {

/// Keys are dotted: `cell` of the table [grid] is "grid.cell", `density` of the first table of the
/// list [[body]] is "body.0.density". Parts are separated by dots, also where TOML would want
/// quotes.

/// The last part: "cell".
std::string leaf(const std::string& key);

/// All but the last part: "grid", "body.0"; empty when there is one part.
std::string table_of(const std::string& key);

/// A key of an item of a list, taken apart.
struct ItemKey {
  std::string list;  ///< "body"
  std::string item;  ///< "0", or a name
  std::string rest;  ///< "density"; empty for the item itself

  /// The number of the item, if it is given by number.
  std::optional<std::size_t> number() const;
};

/// Splits off the first two parts; nothing when there is one.
std::optional<ItemKey> item_key(const std::string& key);

/// "body.0.density" for body, 0, density; "body.0" when `rest` is empty.
std::string numbered_key(const std::string& list, std::size_t number, const std::string& rest);

}  // namespace zona::studies
