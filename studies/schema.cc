#include "studies/schema.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "studies/toml_document.h"
#include "studies/units.h"

namespace zona::studies {

namespace {

std::string toml_list(const std::vector<std::string>& items) {
  std::string list;
  for (const std::string& item : items) list += (list.empty() ? "" : ", ") + item;
  return "[" + list + "]";
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:g}", value) : fmt::format("{:g} {}", value, unit);
}

std::string section_of(const std::string& key) {
  return key.substr(0, key.rfind('.'));
}

std::string with_article(const std::string& noun) {
  const bool vowel = std::string("aeiou").find(noun.front()) != std::string::npos;
  return (vowel ? "an " : "a ") + noun;
}

/// What one value (an item of a list) must look like, without its range.
std::string expected_item(const Parameter& parameter) {
  switch (parameter.kind) {
    case Parameter::Kind::quantity:
      return with_article(dimension_of(parameter.unit));
    case Parameter::Kind::number:
      return "a number";
    case Parameter::Kind::integer:
      break;
    case Parameter::Kind::boolean:
      return "true or false";
    case Parameter::Kind::choice:
      return (parameter.choices.size() > 1 ? "one of " : "only ") + joined(parameter.choices);
    case Parameter::Kind::text:
      return "a text";
    case Parameter::Kind::file:
      return "the path of a file";
  }
  if (parameter.allowed.empty()) return "a whole number";
  std::vector<std::string> words;
  for (const long value : parameter.allowed) words.push_back(std::to_string(value));
  return "one of " + joined(words);
}

}  // namespace

bool Range::contains(double value) const {
  const bool high_enough = min_allowed ? value >= min : value > min;
  const bool low_enough = max_allowed ? value <= max : value < max;
  return high_enough && low_enough;
}

bool Range::is_everything() const {
  return std::isinf(min) && std::isinf(max);
}

std::string Range::text(const std::string& si_unit) const {
  std::string result;
  if (!std::isinf(min)) result = (min_allowed ? "at least " : "above ") + with_unit(min, si_unit);
  if (std::isinf(max)) return result;
  return result + (result.empty() ? "" : " and ") + (max_allowed ? "at most " : "below ") +
         with_unit(max, si_unit);
}

Parameter& Parameter::in(const std::string& interval) {
  char opening = 0, comma = 0, closing = 0;
  std::istringstream stream(interval);
  stream >> opening >> range.min >> comma >> range.max >> closing;
  range.min_allowed = opening == '[';
  range.max_allowed = closing == ']';
  const bool brackets =
      (range.min_allowed || opening == '(') && (range.max_allowed || closing == ')');
  if (!stream || !brackets || comma != ',' || range.min > range.max) {
    throw std::logic_error("the range of " + key + " is not an interval: " + interval);
  }
  return *this;
}

Parameter& Parameter::one_of(std::vector<long> values) {
  allowed = std::move(values);
  return *this;
}

Parameter& Parameter::or_auto() {
  may_be_auto = true;
  return *this;
}

Parameter& Parameter::or_named(std::vector<NamedValue> named_values) {
  names = std::move(named_values);
  return *this;
}

Parameter& Parameter::exactly(std::size_t count) {
  exact_count = count;
  return *this;
}

Parameter& Parameter::or_none() {
  may_be_empty = true;
  return *this;
}

Parameter& Parameter::without_default() {
  default_toml.clear();
  return *this;
}

Parameter& Parameter::called(std::string symbol_in_the_source) {
  symbol = std::move(symbol_in_the_source);
  return *this;
}

Parameter& Parameter::doc(std::string sentences) {
  documentation = std::move(sentences);
  return *this;
}

std::string Parameter::expectation() const {
  std::string result = expected_item(*this);
  if (!range.is_everything()) result += ", " + range.text(unit);
  std::vector<std::string> words;
  for (const auto& [name, value] : names) words.push_back(name);
  if (!words.empty()) result += ", or one of " + joined(words);
  if (may_be_auto) result += ", or \"auto\"";
  if (!is_list) return result;
  return exact_count == 0 ? "a list, each " + result
                          : fmt::format("a list of {}, each {}", exact_count, result);
}

std::string Parameter::example() const {
  if (default_toml.empty() || default_toml == "\"auto\"" || default_toml == "\"\"") {
    if (kind == Kind::quantity) return quoted_toml(example_of(unit));
    if (kind == Kind::file || kind == Kind::text) return "\"trace.csv\"";
  }
  return default_toml;
}

Schema::Schema(std::string kind, std::string summary)
    : kind_(std::move(kind)), summary_(std::move(summary)) {}

void Schema::section(const std::string& name, const std::string& documentation) {
  sections_.push_back({name, documentation});
}

Parameter& Schema::add(const std::string& key, Parameter::Kind kind, std::string default_toml) {
  if (find(key) != nullptr) throw std::logic_error("the key " + key + " is declared twice");
  if (sections_.empty() || section_of(key) != sections_.back().name) {
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
  std::vector<std::string> items;
  for (const std::string& value : values) items.push_back(quoted_toml(value));
  Parameter& parameter = add(key, Parameter::Kind::quantity, toml_list(items));
  parameter.unit = unit;
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
  std::vector<std::string> items;
  for (const std::string& value : values) items.push_back(quoted_toml(value));
  Parameter& parameter = add(key, Parameter::Kind::choice, toml_list(items));
  parameter.choices = allowed;
  parameter.is_list = true;
  return parameter;
}

Parameter& Schema::text(const std::string& key, const std::string& value) {
  return add(key, Parameter::Kind::text, quoted_toml(value));
}

Parameter& Schema::file(const std::string& key, const std::string& value) {
  return add(key, Parameter::Kind::file, quoted_toml(value));
}

void Schema::check(CrossCheck cross_check) {
  cross_checks_.push_back(std::move(cross_check));
}

const Parameter* Schema::find(const std::string& key) const {
  for (const Parameter& parameter : parameters_) {
    if (parameter.key == key) return &parameter;
  }
  return nullptr;
}

std::vector<std::string> Schema::keys() const {
  std::vector<std::string> result;
  for (const Parameter& parameter : parameters_) result.push_back(parameter.key);
  return result;
}

std::string joined(const std::vector<std::string>& words, const std::string& last) {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) result += i + 1 == words.size() ? last : ", ";
    result += words[i];
  }
  return result;
}

}  // namespace zona::studies
