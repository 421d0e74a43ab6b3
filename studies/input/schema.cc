#include "studies/input/schema.h"

#include <fmt/format.h>

#include <stdexcept>

#include "studies/input/configuration.h"
#include "studies/input/keys.h"
#include "studies/input/toml_document.h"

namespace zona::studies {

Schema::Schema(std::string kind, std::string summary)
    : kind_(std::move(kind)), summary_(std::move(summary)) {}

void Schema::section(const std::string& name, const std::string& documentation) {
  sections_.push_back({name, documentation, false, 0});
}

void Schema::list(const std::string& name, const std::string& documentation, std::size_t least,
                  bool must_be_named) {
  sections_.push_back({name, documentation, true, least});
  Parameter& parameter = add(name + ".name", Parameter::Kind::name, "\"auto\"");
  parameter.doc("Name in messages, results and --set.");
  if (must_be_named) {
    parameter.without_default();
  } else {
    parameter.or_auto().doc(
        "Name in messages, results and --set; \"auto\" is the table's number, from "
        "0.");
  }
}

Parameter& Schema::add(const std::string& key, Parameter::Kind kind, std::string default_toml) {
  if (find(key) != nullptr) throw std::logic_error("the key " + key + " is declared twice");
  if (sections_.empty() || table_of(key) != sections_.back().name) {
    throw std::logic_error("the key " + key + " stands outside its section");
  }
  Parameter parameter;
  parameter.key = key;
  parameter.kind = kind;
  parameter.default_toml = std::move(default_toml);
  parameters_.push_back(std::move(parameter));
  return parameters_.back();
}

Parameter& Schema::quantity(const std::string& key, const std::string& unit,
                            const std::string& value) {
  Parameter& parameter = add(key, Parameter::Kind::quantity, quoted_toml(value));
  parameter.unit = unit;
  return parameter;
}

Parameter& Schema::quantities(const std::string& key, const std::string& unit,
                              const std::vector<std::string>& values) {
  Parameter& parameter = add(key, Parameter::Kind::quantity, toml_list(quoted_toml(values)));
  parameter.unit = unit;
  parameter.is_list = true;
  return parameter;
}

Parameter& Schema::formula(const std::string& key, const std::string& unit,
                           const std::vector<std::string>& variables, const std::string& value) {
  Parameter& parameter = add(key, Parameter::Kind::formula, quoted_toml(value));
  parameter.unit = unit;
  parameter.variables = variables;
  return parameter;
}

Parameter& Schema::formulas(const std::string& key, const std::string& unit,
                            const std::vector<std::string>& variables,
                            const std::vector<std::string>& values) {
  Parameter& parameter = formula(key, unit, variables, "");
  parameter.default_toml = toml_list(quoted_toml(values));
  parameter.is_list = true;
  return parameter;
}

Parameter& Schema::number(const std::string& key, double value) {
  return add(key, Parameter::Kind::number, fmt::format("{}", value));
}

Parameter& Schema::numbers(const std::string& key, const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(fmt::format("{}", value));
  Parameter& parameter = add(key, Parameter::Kind::number, toml_list(items));
  parameter.is_list = true;
  return parameter;
}

Parameter& Schema::integer(const std::string& key, long value) {
  return add(key, Parameter::Kind::integer, std::to_string(value));
}

Parameter& Schema::integers(const std::string& key, const std::vector<long>& values) {
  std::vector<std::string> items;
  for (const long value : values) items.push_back(std::to_string(value));
  Parameter& parameter = add(key, Parameter::Kind::integer, toml_list(items));
  parameter.is_list = true;
  return parameter;
}

Parameter& Schema::boolean(const std::string& key, bool value) {
  return add(key, Parameter::Kind::boolean, value ? "true" : "false");
}

Parameter& Schema::choice(const std::string& key, const std::vector<std::string>& choices) {
  Parameter& parameter = add(key, Parameter::Kind::choice, quoted_toml(choices.front()));
  parameter.choices = choices;
  return parameter;
}

Parameter& Schema::choices(const std::string& key, const std::vector<std::string>& allowed,
                           const std::vector<std::string>& values) {
  Parameter& parameter = add(key, Parameter::Kind::choice, toml_list(quoted_toml(values)));
  parameter.choices = allowed;
  parameter.is_list = true;
  return parameter;
}

Parameter& Schema::text(const std::string& key, const std::string& value) {
  return add(key, Parameter::Kind::text, quoted_toml(value));
}

Parameter& Schema::texts(const std::string& key, const std::vector<std::string>& values) {
  Parameter& parameter = add(key, Parameter::Kind::text, toml_list(quoted_toml(values)));
  parameter.is_list = true;
  return parameter.or_none();
}

Parameter& Schema::anything(const std::string& key) {
  Parameter& parameter = add(key, Parameter::Kind::any, "[]");
  parameter.is_list = true;
  return parameter.or_none();
}

Parameter& Schema::bound(const std::string& key) {
  return add(key, Parameter::Kind::any, quoted_toml("auto")).or_auto();
}

Parameter& Schema::reference(const std::string& key, const std::string& refers_to) {
  Parameter& parameter = add(key, Parameter::Kind::name, "");
  parameter.refers_to = refers_to;
  return parameter;
}

Parameter& Schema::references(const std::string& key, const std::string& refers_to) {
  Parameter& parameter = reference(key, refers_to);
  parameter.default_toml = "[]";
  parameter.is_list = true;
  return parameter;
}

Parameter& Schema::file(const std::string& key, const std::string& value) {
  return add(key, Parameter::Kind::file, quoted_toml(value));
}

void Schema::check(CrossCheck cross_check) {
  if (!checked_) return cross_checks_.push_back(std::move(cross_check));
  cross_checks_.push_back(
      [=, applies = checked_](const Configuration& study, const Complain& complain) {
        if (applies(study)) cross_check(study, complain);
      });
}

void Schema::check_each(const std::string& list, ItemCheck check) {
  if (!checked_) return static_cast<void>(item_checks_.emplace_back(list, std::move(check)));
  item_checks_.emplace_back(list,
                            [=, applies = checked_](const Table& item, const Complain& complain) {
                              if (applies(item.study())) check(item, complain);
                            });
}

void Schema::check_table(const std::string& name, ItemCheck check) {
  if (find_section(name)->is_list) return check_each(name, std::move(check));
  this->check([=](const Configuration& study, const Complain& complain) {
    const Table table = study.table(name);
    check(table, [&](const std::string& leaf, const std::string& message) {
      complain(table.key(leaf), message);
    });
  });
}

const Parameter* Schema::find(const std::string& key) const {
  std::string declared = key;
  if (const auto item = item_key(key); item && item->number() && !item->rest.empty()) {
    const Section* section = find_section(item->list);
    if (section != nullptr && section->is_list) declared = item->list + "." + item->rest;
  }
  for (const Parameter& parameter : parameters_) {
    if (parameter.key == declared) return &parameter;
  }
  return nullptr;
}

const Section* Schema::find_section(const std::string& name) const {
  for (const Section& section : sections_) {
    if (section.name == name) return &section;
  }
  return nullptr;
}

std::vector<std::string> Schema::keys() const {
  std::vector<std::string> result;
  for (const Parameter& parameter : parameters_) result.push_back(parameter.key);
  return result;
}

}  // namespace zona::studies
