#include "studies/resolved_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/version.h"

namespace zona::studies {

namespace {

std::string leaf(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

bool is_in(const Parameter& parameter, const Section& section) {
  return parameter.key == section.name + "." + leaf(parameter.key);
}

std::string written(const Configuration& study, const Parameter& parameter) {
  const bool is_path = parameter.kind == Parameter::Kind::file;
  if (is_path) return quoted_toml(study.path(parameter.key).string());
  return study.setting(parameter.key).written.written();
}

std::string si_value(const Setting& setting, const Parameter& parameter) {
  const bool numeric = parameter.kind == Parameter::Kind::quantity ||
                       parameter.kind == Parameter::Kind::number ||
                       parameter.kind == Parameter::Kind::integer;
  if (!numeric || setting.is_auto) return setting.written.written();
  std::string numbers;
  for (const double number : setting.numbers) {
    numbers += fmt::format("{}{:.9g}", numbers.empty() ? "" : ", ", number);
  }
  if (parameter.is_list) numbers = "[" + numbers + "]";
  return parameter.unit.empty() ? numbers : numbers + " " + parameter.unit;
}

std::string origin(const Setting& setting) {
  if (setting.is_default) return "default";
  const std::string place = setting.line > 0 ? fmt::format("line {}", setting.line) : setting.where;
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
  for (const Section& section : study.schema().sections()) {
    text += fmt::format("\n[{}]\n", section.name);
    for (const Parameter& parameter : study.schema().parameters()) {
      if (!is_in(parameter, section)) continue;
      const std::string line = leaf(parameter.key) + " = " + written(study, parameter);
      const bool is_default = study.is_default(parameter.key);
      text += is_default ? fmt::format("{:<40}  # default\n", line) : line + "\n";
    }
  }
  return text;
}

std::string si_table(const Configuration& study) {
  std::size_t key_width = 0, value_width = 0;
  for (const Parameter& parameter : study.schema().parameters()) {
    key_width = std::max(key_width, parameter.key.size());
    const std::string value = si_value(study.setting(parameter.key), parameter);
    if (value.size() <= 30) value_width = std::max(value_width, value.size());
  }
  std::string text;
  for (const Parameter& parameter : study.schema().parameters()) {
    const Setting& setting = study.setting(parameter.key);
    text += fmt::format("{:<{}}  {:<{}}  {}\n", parameter.key, key_width,
                        si_value(setting, parameter), value_width, origin(setting));
  }
  return text;
}

}  // namespace zona::studies
