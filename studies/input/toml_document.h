#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace zona::studies {

/// A value as it stands in a TOML document, independent of the TOML library.
struct TomlValue {
  enum class Type { text, integer, number, boolean, list, table, date };
  Type type = Type::text;
  std::string text;              ///< of a text
  std::int64_t integer = 0;      ///< of an integer
  double number = 0;             ///< of an integer or a number
  bool boolean = false;          ///< of a boolean
  std::vector<TomlValue> items;  ///< of a list
  int line = 0;                  ///< where it starts, from 1

  /// The value as TOML text that reads back as the same value; "{...}" for a table or a date.
  std::string written() const;
  /// "a text", "a whole number", ...
  std::string type_name() const;
};

/// One key with its value; tables are flattened, so that the key is dotted ("grid.cell"). A table
/// without entries appears as an entry of type table. Lists of tables are flattened too: every
/// table of [[body]] has an entry of type table with the line of its heading ("body.0"), before
/// those of its keys ("body.0.density").
struct TomlEntry {
  std::string key;
  TomlValue value;
};

/// The text is not TOML.
class TomlError : public std::runtime_error {
 public:
  TomlError(const std::string& message, int line) : std::runtime_error(message), line(line) {}
  int line;
};

/// All entries of a document in the order of their lines. Throws TomlError.
std::vector<TomlEntry> parse_toml(std::string_view text);

/// `text` as a TOML string with its quotes.
std::string quoted_toml(std::string_view text);
std::vector<std::string> quoted_toml(const std::vector<std::string>& texts);

/// Values that are TOML text as a TOML list.
std::string toml_list(const std::vector<std::string>& values);

}  // namespace zona::studies
