#include "studies/input/unknown_key.h"

#include <fmt/format.h>

#include "studies/input/input_error.h"
#include "studies/input/keys.h"
#include "studies/input/nearest.h"

namespace zona::studies {

namespace {

/// A key without the place in a list: "body.density" for "body.0.density".
std::string declared_form(const Schema& schema, const std::string& key) {
  const auto item = item_key(key);
  if (!item || item->rest.empty()) return key;
  const Section* section = schema.find_section(item->list);
  return section != nullptr && section->is_list ? item->list + "." + item->rest : key;
}

/// A table where a value is wanted, a value where a table is, or [x] for [[x]]; else empty.
std::string wrong_form_message(const Schema& schema, const TomlEntry& entry) {
  const auto item = item_key(entry.key);
  const Section* section = schema.find_section(item ? item->list : entry.key);
  if (section != nullptr && !section->is_list && (!item || item->number())) {
    return item ? fmt::format("is a table, not a list of tables; write [{}]", section->name)
                : fmt::format("is a table, not a value; write [{}] and its keys below", entry.key);
  }
  if (section != nullptr && section->is_list && (!item || !item->number())) {
    return fmt::format("is a list of tables; write [[{}]] and the keys of one below",
                       section->name);
  }
  const std::string declared = declared_form(schema, entry.key);
  for (const std::string& key : schema.keys()) {
    if (declared.rfind(key + ".", 0) != 0) continue;
    return fmt::format("{} is a value, not a table; write e.g. {} = {}", key, leaf(key),
                       schema.find(key)->example());
  }
  return "";
}

std::vector<std::string> names_like(const Schema& schema, const TomlEntry& entry) {
  if (entry.value.type != TomlValue::Type::table) return schema.keys();
  std::vector<std::string> names;
  for (const Section& section : schema.sections()) names.push_back(section.name);
  return names;
}

}  // namespace

std::string unknown_key_message(const Schema& schema, const TomlEntry& entry,
                                const std::vector<const Schema*>& schemas) {
  const std::string wrong_form = wrong_form_message(schema, entry);
  if (!wrong_form.empty()) return wrong_form;
  const std::string unknown = fmt::format("unknown key of a {} study", schema.kind());
  std::string declared = declared_form(schema, entry.key);
  if (entry.value.type == TomlValue::Type::table)
    declared = entry.key.substr(0, entry.key.find('.'));
  const std::string nearest = nearest_name(declared, names_like(schema, entry));
  if (!nearest.empty()) {
    const bool same_item = declared != entry.key && table_of(nearest) == table_of(declared) &&
                           schema.find(nearest) != nullptr;
    return unknown + "; did you mean " + (same_item ? leaf(nearest) : nearest) + "?";
  }
  for (const Schema* other : schemas) {
    if (other->find(entry.key) == nullptr) continue;
    return fmt::format("{}; it belongs to a {} study; remove it", unknown, other->kind());
  }
  return unknown + "; remove it (\"zona help\" lists the keys)";
}

std::string unknown_table(const Schema& schema, const std::string& key) {
  const auto item = item_key(key);
  if (!item) return "";
  const Section* section = schema.find_section(item->list);
  const bool is_list = section != nullptr && section->is_list;
  if (is_list != item->number().has_value()) return item->list + "." + item->item;
  return "";
}

}  // namespace zona::studies
