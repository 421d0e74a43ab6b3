#include "studies/input/toml_document.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>

namespace zona::studies {

namespace {

TomlValue converted(const toml::node& node);

TomlValue converted_list(const toml::array& array) {
  TomlValue value;
  value.type = TomlValue::Type::list;
  for (const toml::node& item : array) value.items.push_back(converted(item));
  return value;
}

TomlValue converted(const toml::node& node) {
  TomlValue value;
  value.type = node.is_table() ? TomlValue::Type::table : TomlValue::Type::date;
  if (const auto* array = node.as_array()) value = converted_list(*array);
  if (const auto* text = node.as_string()) {
    value.type = TomlValue::Type::text;
    value.text = text->get();
  }
  if (const auto* integer = node.as_integer()) {
    value.type = TomlValue::Type::integer;
    value.integer = integer->get();
    value.number = static_cast<double>(value.integer);
  }
  if (const auto* number = node.as_floating_point()) {
    value.type = TomlValue::Type::number;
    value.number = number->get();
  }
  if (const auto* boolean = node.as_boolean()) {
    value.type = TomlValue::Type::boolean;
    value.boolean = boolean->get();
  }
  value.line = static_cast<int>(node.source().begin.line);
  return value;
}

/// A part of a dotted key; quoted when it would otherwise read as something else.
std::string key_part(std::string_view part) {
  const auto bare = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  const bool plain = !part.empty() && std::all_of(part.begin(), part.end(), bare);
  return plain ? std::string(part) : quoted_toml(part);
}

void flatten(const toml::table& table, const std::string& prefix, std::vector<TomlEntry>& entries);

void flatten_list(const toml::array& tables, const std::string& key,
                  std::vector<TomlEntry>& entries) {
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string item = key + "." + std::to_string(i);
    entries.push_back({item, converted(tables[i])});
    flatten(*tables[i].as_table(), item + ".", entries);
  }
}

void flatten(const toml::table& table, const std::string& prefix, std::vector<TomlEntry>& entries) {
  for (const auto& [name, node] : table) {
    const std::string key = prefix + key_part(name.str());
    const toml::table* inner = node.as_table();
    if (inner != nullptr && !inner->empty()) {
      flatten(*inner, key + ".", entries);
      continue;
    }
    if (node.is_array_of_tables()) {
      flatten_list(*node.as_array(), key, entries);
      continue;
    }
    TomlEntry entry{key, converted(node)};
    if (name.source().begin.line > 0) entry.value.line = static_cast<int>(name.source().begin.line);
    entries.push_back(std::move(entry));
  }
}

std::string written_number(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number < 0 ? "-inf" : "inf";
  const std::string text = fmt::format("{}", number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

}  // namespace

std::string TomlValue::written() const {
  switch (type) {
    case Type::text:
      return quoted_toml(text);
    case Type::integer:
      return fmt::format("{}", integer);
    case Type::number:
      return written_number(number);
    case Type::boolean:
      return boolean ? "true" : "false";
    case Type::list:
      break;
    case Type::table:
    case Type::date:
      return "{...}";
  }
  std::string list;
  for (const TomlValue& item : items) list += (list.empty() ? "" : ", ") + item.written();
  return "[" + list + "]";
}

std::string TomlValue::type_name() const {
  switch (type) {
    case Type::text:
      return "a text";
    case Type::integer:
      return "a whole number";
    case Type::number:
      return "a number";
    case Type::boolean:
      return "a boolean";
    case Type::list:
      return "a list";
    case Type::table:
      return "a table";
    case Type::date:
      return "a date or time of day";
  }
  return "a value";
}

std::vector<TomlEntry> parse_toml(std::string_view text) {
  std::vector<TomlEntry> entries;
  try {
    const toml::table document = toml::parse(text);
    flatten(document, "", entries);
  } catch (const toml::parse_error& error) {
    throw TomlError(std::string(error.description()), static_cast<int>(error.source().begin.line));
  }
  std::stable_sort(entries.begin(), entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
    return a.value.line < b.value.line;
  });
  return entries;
}

std::string toml_list(const std::vector<std::string>& values) {
  std::string list;
  for (const std::string& value : values) list += (list.empty() ? "" : ", ") + value;
  return "[" + list + "]";
}

std::vector<std::string> quoted_toml(const std::vector<std::string>& texts) {
  std::vector<std::string> result;
  for (const std::string& text : texts) result.push_back(quoted_toml(text));
  return result;
}

std::string quoted_toml(std::string_view text) {
  std::string result = "\"";
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      result += '\\';
      result += character;
    } else if (byte < 0x20 || byte == 0x7F) {
      result += fmt::format("\\u{:04X}", byte);
    } else {
      result += character;
    }
  }
  return result + "\"";
}

}  // namespace zona::studies
