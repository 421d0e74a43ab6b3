#include "studies/input/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "studies/input/toml_document.h"
#include "studies/input/units.h"

namespace zona::studies {

namespace {

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:g}", value) : fmt::format("{:g} {}", value, unit);
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
    case Parameter::Kind::formula:
      return with_article(dimension_of(parameter.unit)) + " or a formula of " +
             joined(parameter.variables, " and ") + " in SI";
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
    case Parameter::Kind::name:
      return parameter.refers_to.empty() ? "a name of letters, digits, _ and -"
                                         : "the name of a [[" + parameter.refers_to + "]]";
    case Parameter::Kind::file:
      return "the path of a file";
    case Parameter::Kind::any:
      return "a text, a number, true or false";
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

Parameter& Parameter::auto_by_default() {
  default_toml = quoted_toml("auto");
  return or_auto();
}

Parameter& Parameter::or_named(std::vector<NamedValue> named_values) {
  names = std::move(named_values);
  return *this;
}

Parameter& Parameter::exactly(std::size_t count) {
  exact_count = count;
  return *this;
}

Parameter& Parameter::or_one_for_all() {
  one_for_all = true;
  return *this;
}

Parameter& Parameter::or_none() {
  may_be_empty = true;
  return *this;
}

Parameter& Parameter::only_with(const std::string& choice_key, std::vector<std::string> values) {
  conditions.push_back({choice_key, std::move(values)});
  return *this;
}

Parameter& Parameter::only_where(Condition condition) {
  conditions.push_back(std::move(condition));
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
  const std::string item = result;
  result = exact_count == 0 ? "a list, each " + item
                            : fmt::format("a list of {}, each {}", exact_count, item);
  return one_for_all ? result + "; one alone stands for all" : result;
}

std::string Parameter::example() const {
  const bool tells_nothing = default_toml.empty() || default_toml == "\"auto\"" ||
                             default_toml == "\"\"" || kind == Kind::any;
  if (tells_nothing) {
    std::string item = default_toml;
    if (kind == Kind::quantity || kind == Kind::formula) item = quoted_toml(example_of(unit));
    if (kind == Kind::file || kind == Kind::text) item = "\"trace.csv\"";
    if (kind == Kind::name) item = "\"left\"";
    if (kind == Kind::choice) item = quoted_toml(choices.front());
    if (kind == Kind::number || kind == Kind::integer) item = "1";
    if (kind == Kind::any) item = "\"60 us\"";
    return is_list
               ? toml_list(std::vector<std::string>(std::max<std::size_t>(exact_count, 1), item))
               : item;
  }
  return default_toml;
}

std::string Condition::text() const {
  return key + " = " + joined(quoted_toml(values));
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
