#include "studies/input/configuration.h"

#include <stdexcept>

#include "studies/input/keys.h"

namespace zona::studies {

Configuration::Configuration(const Schema& schema, std::filesystem::path file)
    : schema_(&schema), file_(std::move(file)) {}

std::filesystem::path Configuration::base_directory() const {
  return std::filesystem::absolute(file_).parent_path();
}

const Setting& Configuration::setting(const std::string& key) const {
  const auto found = settings_.find(key);
  if (found != settings_.end()) return found->second;
  if (has(key)) throw MissingSetting("the value of " + key + " is invalid");
  throw std::logic_error("a " + kind() + " study has no key " + key);
}

const Setting& Configuration::of_kind(const std::string& key, Parameter::Kind kind,
                                      bool is_list) const {
  const Setting& result = setting(key);
  const Parameter& parameter = *schema_->find(key);
  if (parameter.kind != kind || parameter.is_list != is_list) {
    throw std::logic_error("the key " + key + " is read as the wrong type");
  }
  if (result.is_auto) throw std::logic_error("the key " + key + " is \"auto\"; ask is_auto first");
  return result;
}

double Configuration::quantity(const std::string& key) const {
  return of_kind(key, Parameter::Kind::quantity, false).numbers.front();
}

double Configuration::number(const std::string& key) const {
  return of_kind(key, Parameter::Kind::number, false).numbers.front();
}

long Configuration::integer(const std::string& key) const {
  return static_cast<long>(of_kind(key, Parameter::Kind::integer, false).numbers.front());
}

bool Configuration::boolean(const std::string& key) const {
  return of_kind(key, Parameter::Kind::boolean, false).written.boolean;
}

const std::string& Configuration::choice(const std::string& key) const {
  return of_kind(key, Parameter::Kind::choice, false).texts.front();
}

const std::string& Configuration::text(const std::string& key) const {
  const Setting& result = setting(key);
  if (result.texts.size() != 1) throw std::logic_error("the key " + key + " is not one text");
  return result.texts.front();
}

std::filesystem::path Configuration::path(const std::string& key) const {
  const std::string& name = of_kind(key, Parameter::Kind::file, false).texts.front();
  if (name.empty()) return {};
  const std::filesystem::path& directory = setting(key).directory;
  return (directory.empty() ? base_directory() : directory) / name;
}

std::vector<double> Configuration::quantities(const std::string& key) const {
  return of_kind(key, Parameter::Kind::quantity, true).numbers;
}

std::vector<double> Configuration::numbers(const std::string& key) const {
  return of_kind(key, Parameter::Kind::number, true).numbers;
}

Formula Configuration::formula(const std::string& key) const {
  return {of_kind(key, Parameter::Kind::formula, false).texts.front(), *schema_->find(key)};
}

std::vector<Formula> Configuration::formulas(const std::string& key) const {
  std::vector<Formula> formulas;
  for (const std::string& text : of_kind(key, Parameter::Kind::formula, true).texts) {
    formulas.emplace_back(text, *schema_->find(key));
  }
  return formulas;
}

std::vector<long> Configuration::integers(const std::string& key) const {
  const std::vector<double>& numbers = of_kind(key, Parameter::Kind::integer, true).numbers;
  return {numbers.begin(), numbers.end()};
}

std::vector<std::string> Configuration::texts(const std::string& key) const {
  return setting(key).texts;
}

Table Configuration::table(const std::string& name) const {
  return {*this, name};
}

std::vector<Table> Configuration::items(const std::string& list) const {
  std::vector<Table> result;
  for (std::size_t i = 0; i < item_count(list); ++i) {
    result.emplace_back(*this, numbered_key(list, i, ""));
  }
  return result;
}

const std::vector<ItemHeading>& Configuration::headings(const std::string& list) const {
  static const std::vector<ItemHeading> none;
  const auto found = headings_.find(list);
  return found == headings_.end() ? none : found->second;
}

std::vector<std::string> Configuration::item_names(const std::string& list) const {
  std::vector<std::string> names;
  for (const ItemHeading& heading : headings(list)) names.push_back(heading.name);
  return names;
}

std::vector<std::string> Configuration::tables() const {
  std::vector<std::string> names;
  for (const Section& section : schema_->sections()) {
    if (!section.is_list) names.push_back(section.name);
    for (std::size_t i = 0; i < item_count(section.name); ++i) {
      names.push_back(numbered_key(section.name, i, ""));
    }
  }
  return names;
}

std::vector<std::string> Configuration::keys_of(const std::string& table) const {
  const auto item = item_key(table);
  const std::string& section = item ? item->list : table;
  std::vector<std::string> keys;
  for (const Parameter& parameter : schema_->parameters()) {
    const std::string key = table + "." + leaf(parameter.key);
    if (table_of(parameter.key) == section && applies(key)) keys.push_back(key);
  }
  return keys;
}

std::string Configuration::shown_key(const std::string& key) const {
  const auto item = item_key(key);
  if (!item || !item->number() || *item->number() >= item_count(item->list)) return key;
  const std::string& name = headings(item->list)[*item->number()].name;
  if (name.empty() || name == "auto") return key;
  return item->list + "." + name + (item->rest.empty() ? "" : "." + item->rest);
}

bool Configuration::is_auto(const std::string& key) const {
  return setting(key).is_auto;
}

bool Configuration::is_default(const std::string& key) const {
  return setting(key).is_default;
}

int Configuration::line_of(const std::string& key) const {
  return setting(key).line;
}

Problem Configuration::problem(const std::string& key, const std::string& message) const {
  const std::string shown = shown_key(key);
  const auto found = settings_.find(key);
  if (found != settings_.end() && !found->second.where.empty()) {
    return {found->second.where, shown, message, found->second.line};
  }
  const auto item = item_key(key);
  if (item && item->number() && *item->number() < item_count(item->list)) {
    const ItemHeading& heading = headings(item->list)[*item->number()];
    return {heading.where, shown, message, heading.line};
  }
  return {file_.string(), shown, message, 0};
}

void Configuration::set_items(const std::string& list, std::vector<ItemHeading> headings) {
  headings_[list] = std::move(headings);
}

std::string Table::name() const {
  return is_auto("name") ? studies::leaf(name_) : text("name");
}

void Configuration::set(const std::string& key, Setting setting) {
  settings_[key] = std::move(setting);
}

}  // namespace zona::studies
