#include "studies/input/study_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>

#include "studies/input/source_layers.h"

namespace zona::studies {

namespace {

constexpr std::size_t largest_file = 4 << 20;  // bytes; a study is a few kilobytes
constexpr int most_files = 10;                 // a study and those that it is based on

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
  std::string text;
  std::array<char, 1 << 14> part;
  do {
    stream.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream && text.size() <= largest_file);
  if (stream.bad()) throw InputError(file.string(), "cannot be read");
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

/// The entries of one override, ready to amend a study.
std::vector<SourcedEntry> override_layer(const std::string& text, StudySource& source) {
  std::vector<SourcedEntry> layer;
  for (TomlEntry& entry : parse_override(text, source)) {
    if (entry.key == "base") {
      source.problems.push_back(override_problem("base", "belongs in a study file"));
      continue;
    }
    entry.value.line = 0;
    layer.push_back({std::move(entry), "--set", 0, 0, {}, true});
  }
  return layer;
}

/// The entries of one file, in the order of its lines.
std::vector<SourcedEntry> file_layer(const std::filesystem::path& file, int layer) {
  std::vector<SourcedEntry> entries;
  try {
    for (TomlEntry& entry : parse_toml(read_file(file))) {
      const int line = entry.value.line;
      entries.push_back({std::move(entry), fmt::format("{}:{}", file.string(), line), line, layer,
                         std::filesystem::absolute(file).parent_path(), false});
    }
  } catch (const TomlError& error) {
    throw InputError(Problem{fmt::format("{}:{}", file.string(), error.line), "",
                             fmt::format("this is not TOML: {}; a line reads e.g. cell = \"6 um\"",
                                         printable(error.what(), 300)),
                             error.line});
  }
  return entries;
}

/// The file that the entry `base` names; nothing when it cannot be one.
std::optional<std::filesystem::path> base_of(const SourcedEntry& base, StudySource& source) {
  const auto refuse = [&](const std::string& message) {
    source.problems.push_back({base.where, "base", message, base.line});
    return std::nullopt;
  };
  const TomlValue& value = base.entry.value;
  if (value.type != TomlValue::Type::text || value.text.empty() ||
      value.text.find('\0') != std::string::npos) {
    return refuse(
        fmt::format("{} is not the path of a study file; write e.g. base = "
                    "\"piercing_lateral.toml\"",
                    printable(value.written())));
  }
  const std::filesystem::path file = (base.directory / value.text).lexically_normal();
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure)) {
    return refuse(
        fmt::format("there is no file {}; relative paths start at the file that names "
                    "them",
                    printable(file.string(), 400)));
  }
  return file;
}

/// Reads a file and what it is based on. `layer` counts the files above it.
void read_files(const std::filesystem::path& file, int layer, StudySource& source) {
  std::vector<SourcedEntry> entries = file_layer(file, layer);
  const auto is_base = [](const SourcedEntry& entry) { return entry.entry.key == "base"; };
  const auto found = std::find_if(entries.begin(), entries.end(), is_base);
  if (found == entries.end()) return amend(source, std::move(entries));
  const SourcedEntry base = *found;
  entries.erase(found);
  for (SourcedEntry& entry : entries) entry.amends = true;
  if (layer == most_files) {
    source.problems.push_back({base.where, "base",
                               fmt::format("is the {}th file in a row that is based on another; "
                                           "perhaps a file is based on itself",
                                           layer),
                               base.line});
  } else if (const auto next = base_of(base, source)) {
    read_files(*next, layer + 1, source);
  }
  amend(source, std::move(entries));
}

}  // namespace

StudySource read_study_source(const std::filesystem::path& file,
                              const std::vector<std::string>& overrides) {
  StudySource source;
  read_files(file, 1, source);
  for (const std::string& text : overrides) amend(source, override_layer(text, source));
  return source;
}

}  // namespace zona::studies
