#include "studies/run/resolved_study.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>

#include "studies/input/keys.h"
#include "studies/run/version.h"

namespace zona::studies {

namespace {

std::string written(const Configuration& study, const std::string& key) {
  const bool is_path = study.schema().find(key)->kind == Parameter::Kind::file;
  if (is_path) return quoted_toml(study.path(key).string());
  return study.setting(key).written.written();
}

/// A constant in SI, a formula as it is written.
std::string item_in_si(const Setting& setting, const Parameter& parameter, std::size_t i) {
  const bool is_formula = parameter.kind == Parameter::Kind::formula &&
                          !Formula(setting.texts[i], parameter).constant();
  return is_formula ? quoted_toml(setting.texts[i]) : fmt::format("{:.9g}", setting.numbers[i]);
}

std::string value_in_si(const Setting& setting, const Parameter& parameter) {
  const bool numeric =
      parameter.kind == Parameter::Kind::quantity || parameter.kind == Parameter::Kind::formula ||
      parameter.kind == Parameter::Kind::number || parameter.kind == Parameter::Kind::integer;
  if (!numeric || setting.is_auto) return setting.written.written();
  std::string numbers;
  for (std::size_t i = 0; i < setting.numbers.size(); ++i) {
    numbers += (numbers.empty() ? "" : ", ") + item_in_si(setting, parameter, i);
  }
  if (parameter.is_list) numbers = "[" + numbers + "]";
  return parameter.unit.empty() ? numbers : numbers + " " + parameter.unit;
}

/// "line 7", "--set", or "base.toml:7" of a file that the study is based on.
std::string place_of(const Setting& setting) {
  if (setting.is_inherited) return std::filesystem::path(setting.where).filename().string();
  return setting.line > 0 ? fmt::format("line {}", setting.line) : setting.where;
}

std::string origin(const Setting& setting) {
  if (setting.is_default) return "default";
  const std::string place = place_of(setting);
  return setting.written.type == TomlValue::Type::text ||
                 setting.written.type == TomlValue::Type::list
             ? fmt::format("{}: {}", place, printable(setting.written.written(), 40))
             : place;
}

}  // namespace

std::string resolved_study(const Configuration& study) {
  std::string text =
      fmt::format("# {} with every parameter, as zona {} understood it.\nstudy = \"{}\"\n",
                  printable(study.file().filename().string()), zona_version(), study.kind());
  for (const std::string& table : study.tables()) {
    const auto item = item_key(table);
    text += "\n" + study.schema().find_section(item ? item->list : table)->heading() + "\n";
    for (const std::string& key : study.keys_of(table)) {
      const std::string line = leaf(key) + " = " + written(study, key);
      text += study.is_default(key) ? fmt::format("{:<40}  # default\n", line) : line + "\n";
    }
  }
  return text;
}

namespace {

/// Keys and written values of all parameters that decide the results: all but [run].
std::vector<std::pair<std::string, std::string>> deciding(const Configuration& study) {
  std::vector<std::pair<std::string, std::string>> parameters{{"study", study.kind()}};
  for (const std::string& table : study.tables()) {
    if (table == "run") continue;
    for (const std::string& key : study.keys_of(table)) {
      parameters.emplace_back(study.shown_key(key), written(study, key));
    }
  }
  return parameters;
}

}  // namespace

std::string first_difference(const Configuration& before, const Configuration& now) {
  const auto old_parameters = deciding(before), parameters = deciding(now);
  for (std::size_t i = 0; i < std::max(old_parameters.size(), parameters.size()); ++i) {
    if (i >= parameters.size()) return old_parameters[i].first + " was given";
    if (i >= old_parameters.size()) return parameters[i].first + " is new";
    const auto& [old_key, old_value] = old_parameters[i];
    const auto& [key, value] = parameters[i];
    if (old_key != key) return fmt::format("{} stood in the place of {}", old_key, key);
    if (old_value != value) {
      return fmt::format("{} was {} and is {}", key, printable(old_value, 60),
                         printable(value, 60));
    }
  }
  return "";
}

std::string study_fingerprint(const Configuration& study) {
  std::string text;
  for (const auto& [key, value] : deciding(study)) text += key + " = " + value + "\n";
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::string si_table(const Configuration& study) {
  struct Row {
    std::string key, value, origin;
  };
  std::vector<Row> rows;
  std::size_t key_width = 0, value_width = 0;
  for (const std::string& table : study.tables()) {
    for (const std::string& key : study.keys_of(table)) {
      const Setting& setting = study.setting(key);
      rows.push_back(
          {study.shown_key(key), value_in_si(setting, *study.schema().find(key)), origin(setting)});
      key_width = std::max(key_width, rows.back().key.size());
      const std::size_t width = rows.back().value.size();
      if (width <= 30) value_width = std::max(value_width, width);
    }
  }
  std::string text;
  for (const Row& row : rows) {
    text +=
        fmt::format("{:<{}}  {:<{}}  {}\n", row.key, key_width, row.value, value_width, row.origin);
  }
  return text;
}

}  // namespace zona::studies
