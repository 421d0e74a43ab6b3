#include "studies/program/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "studies/input/keys.h"
#include "studies/input/nearest.h"
#include "studies/kinds/study_kinds.h"

namespace zona::studies {

namespace {

std::string default_text(const Parameter& parameter) {
  return parameter.is_required() ? "none: must be set" : parameter.default_toml;
}

/// "Only where `shape = "box"`. "; empty for a key that always applies.
std::string conditions(const Parameter& parameter, const std::string& quote) {
  std::string text;
  for (const Condition& condition : parameter.conditions) {
    text += (text.empty() ? "Only where " : " and ") + quote + condition.text() + quote;
  }
  return text.empty() ? "" : text + ". ";
}

std::string markdown_table(const Schema& schema, const Section& section) {
  std::string text = section.documentation +
                     "\n\n| Key | Default | Allowed | Meaning |\n| --- | --- | --- | --- |\n";
  for (const Parameter& parameter : schema.parameters()) {
    if (table_of(parameter.key) != section.name) continue;
    const std::string symbol =
        parameter.symbol.empty() ? "" : fmt::format(" Symbol: {}.", parameter.symbol);
    text += fmt::format("| `{}` | `{}` | {} | {}{}{} |\n", leaf(parameter.key),
                        default_text(parameter), parameter.expectation(),
                        conditions(parameter, "`"), parameter.documentation, symbol);
  }
  return text;
}

std::string anchor(const Schema& schema, const Section& section) {
  return schema.kind() + "-" + section.name;
}

std::string full_help(const Parameter& parameter) {
  std::string text = fmt::format("{} = {}\n", parameter.key, default_text(parameter));
  text += fmt::format("    {}{}\n    allowed: {}\n", conditions(parameter, ""),
                      parameter.documentation, parameter.expectation());
  if (!parameter.symbol.empty()) text += fmt::format("    symbol: {}\n", parameter.symbol);
  return text;
}

/// The parameters whose key passes the filter. Kinds that declare one alike share its text.
template <class Filter>
std::string help_of_keys(const Filter& filter) {
  std::vector<std::string> texts;
  std::map<std::string, std::vector<std::string>> kinds;
  for (const StudyKind& kind : study_kinds()) {
    for (const Parameter& parameter : kind.schema->parameters()) {
      if (!filter(*kind.schema, parameter)) continue;
      const std::string text = full_help(parameter);
      if (kinds.find(text) == kinds.end()) texts.push_back(text);
      kinds[text].push_back(kind.schema->kind());
    }
  }
  std::string result;
  for (const std::string& text : texts) {
    result += fmt::format("{}    study: {}\n", text, joined(kinds[text], ", "));
  }
  return result;
}

std::string help_of_kind(const Schema& schema) {
  std::string text = fmt::format("study = \"{}\"\n{}\n", schema.kind(), schema.summary());
  for (const Section& section : schema.sections()) {
    text += fmt::format("\n{}  # {}\n", section.heading(), section.documentation);
    for (const Parameter& parameter : schema.parameters()) {
      if (table_of(parameter.key) != section.name) continue;
      text += fmt::format("{} = {}\n", leaf(parameter.key), default_text(parameter));
    }
  }
  return text;
}

std::string base_help() {
  return "the path of another study file, whose values hold where this one says nothing. Relative "
         "paths start at the file\nthat names them. `[[body]]` and other lists of tables replace "
         "those of the base, `[body.NAME]` amends one of them.\nWhat the base says and does not "
         "apply any more is left out. `--set` amends the whole.\n";
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const StudyKind& kind : study_kinds()) {
    const std::vector<std::string> keys = kind.schema->keys();
    names.insert(names.end(), keys.begin(), keys.end());
  }
  return names;
}

}  // namespace

std::string parameter_reference() {
  std::string text =
      "# Parameters\n\nWritten by `zona reference` from the declarations in `studies/`; do not "
      "edit. "
      "Numbers in brackets are sections,\nequations and tables of the dissertation. Quantities are "
      "texts with a unit, limits are in SI.\n\nAbove all tables stand `study = \"...\"`, the kind "
      "of "
      "the study, and, if wanted, `base = \"...\"`:\n" +
      base_help();
  std::map<std::string, std::string> first_anchor;  // of a table with this content
  for (const StudyKind& kind : study_kinds()) {
    const Schema& schema = *kind.schema;
    text += fmt::format("\n## study = \"{}\"\n\n{}\n", schema.kind(), schema.summary());
    for (const Section& section : schema.sections()) {
      const std::string table = markdown_table(schema, section);
      const std::string place = anchor(schema, section);
      const auto [first, is_new] = first_anchor.emplace(section.heading() + table, place);
      text += fmt::format("\n<a id=\"{}\"></a>\n### {}\n\n", place, section.heading());
      text += is_new ? table : fmt::format("As [{}](#{}).\n", first->second, first->second);
    }
  }
  return text;
}

std::string parameter_help(const std::string& name) {
  for (const StudyKind& kind : study_kinds()) {
    if (kind.schema->kind() == name) return help_of_kind(*kind.schema);
  }
  if (name == "base") return "base = \"...\"\n" + base_help();
  const std::string key = help_of_keys(
      [&](const Schema&, const Parameter& parameter) { return parameter.key == name; });
  if (!key.empty()) return key;
  const std::string prefix = name.empty() || name.back() == '.' ? name : name + ".";
  std::string section = help_of_keys([&](const Schema&, const Parameter& parameter) {
    return parameter.key.rfind(prefix, 0) == 0 || leaf(parameter.key) == name;
  });
  if (section.empty()) {
    section = help_of_keys([&](const Schema&, const Parameter& parameter) {
      return parameter.key.rfind(name, 0) == 0;
    });
  }
  if (!section.empty()) return section;
  const std::string nearest = nearest_name(name, all_names());
  throw InputError("zona help", fmt::format("there is no parameter \"{}\"; {}", printable(name),
                                            nearest.empty() ? "\"zona help\" lists the tables"
                                                            : "did you mean " + nearest + "?"));
}

std::string help_overview() {
  std::string text;
  for (const StudyKind& kind : study_kinds()) {
    text += fmt::format("study = \"{}\"\n    {}\n    tables:", kind.schema->kind(),
                        kind.schema->summary());
    for (const Section& section : kind.schema->sections()) text += " " + section.name;
    text += "\n\n";
  }
  return text +
         "zona help KIND      all keys of a study kind with their defaults\n"
         "zona help TABLE     the parameters of a table, e.g. zona help grid\n"
         "zona help KEY       one parameter, e.g. zona help grid.cell\n";
}

}  // namespace zona::studies
