#include "studies/study_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "studies/source_items.h"

namespace zona::studies {

namespace {

constexpr std::size_t largest_file = 4 << 20;  // bytes; a study is a few kilobytes

std::string read_file(const std::filesystem::path& file) {
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure)) {
    throw InputError(file.string(), "is a directory; give a study file (\"zona list\" names some)");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError(file.string(),
                     "cannot be opened; give the path of a study file (\"zona list\" names some)");
  }
  std::string text(largest_file + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw InputError(file.string(), "cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > largest_file) {
    throw InputError(file.string(), "is larger than 4 MiB; this cannot be a study file");
  }
  return text;
}

Problem override_problem(std::string key, std::string message) {
  return {"--set", std::move(key), std::move(message), 0};
}

/// Entries of one override; more than one when the value is an inline table.
std::vector<TomlEntry> parse_override(const std::string& text, StudySource& source) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    source.problems.push_back(override_problem(
        printable(text), "is not of the form key=value; write e.g. --set 'grid.cell=\"4 um\"'"));
    return {};
  }
  const std::string key = text.substr(0, equals);
  const std::string value = text.substr(equals + 1);
  try {
    std::vector<TomlEntry> entries = parse_toml(key + " = " + value);
    const bool more = std::any_of(entries.begin(), entries.end(),
                                  [](const TomlEntry& entry) { return entry.value.line > 1; });
    if (!more) return entries;
    source.problems.push_back(
        override_problem(key, "has more than one line; set one key at a time"));
  } catch (const TomlError& error) {
    source.problems.push_back(override_problem(
        key, fmt::format("{} is not a TOML value; texts and quantities need quotes that the shell "
                         "leaves alone; write --set '{}=\"{}\"'",
                         printable(value), printable(key), printable(value))));
  }
  return {};
}

/// Whether an override of `key` gives a whole list of tables, perhaps an empty one.
bool is_whole_list(const std::string& key, const std::vector<TomlEntry>& entries) {
  if (entries.empty()) return false;
  const TomlEntry& first = entries.front();
  const bool empty = first.value.type == TomlValue::Type::list && first.value.items.empty();
  return (empty && first.key == key) ||
         (first.value.type == TomlValue::Type::table && first.key == key + ".0");
}

void apply_override(TomlEntry entry, StudySource& source) {
  entry.key = with_item_numbers(source.entries, entry.key);
  const auto same_key = [&](const SourcedEntry& other) { return other.entry.key == entry.key; };
  const auto found = std::find_if(source.entries.begin(), source.entries.end(), same_key);
  if (found != source.entries.end() && found->where == "--set") {
    source.problems.push_back(override_problem(entry.key, "is set twice; set it once"));
    return;
  }
  if (found != source.entries.end()) source.entries.erase(found);
  entry.value.line = 0;
  source.entries.push_back({std::move(entry), "--set", 0});
}

}  // namespace

StudySource read_study_source(const std::filesystem::path& file,
                              const std::vector<std::string>& overrides) {
  StudySource source;
  try {
    for (TomlEntry& entry : parse_toml(read_file(file))) {
      const int line = entry.value.line;
      source.entries.push_back({std::move(entry), fmt::format("{}:{}", file.string(), line), line});
    }
  } catch (const TomlError& error) {
    throw InputError({Problem{fmt::format("{}:{}", file.string(), error.line), "",
                              fmt::format("this is not TOML: {}; a line reads e.g. cell = \"6 um\"",
                                          printable(error.what(), 300)),
                              error.line}});
  }
  for (const std::string& text : overrides) {
    std::vector<TomlEntry> entries = parse_override(text, source);
    const std::string key = text.substr(0, text.find('='));
    if (is_whole_list(key, entries)) erase_list(source.entries, key);
    for (TomlEntry& entry : entries) apply_override(std::move(entry), source);
  }
  return source;
}

}  // namespace zona::studies
