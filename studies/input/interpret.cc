#include "studies/input/interpret.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "studies/input/keys.h"
#include "studies/input/nearest.h"
#include "studies/input/units.h"

namespace zona::studies {

namespace {

using Type = TomlValue::Type;

/// Thrown inside this file only: the value is unusable, what() is the message.
class Unfit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string advice(const Parameter& parameter) {
  return fmt::format("needs {}; write e.g. {} = {}", parameter.expectation(), leaf(parameter.key),
                     printable(parameter.example()));
}

[[noreturn]] void wrong_type(const Parameter& parameter, const TomlValue& value) {
  throw Unfit(fmt::format("{} is {}; {}", printable(value.written()), value.type_name(),
                          advice(parameter)));
}

void check_range(const Parameter& parameter, const TomlValue& value, double number) {
  if (!std::isfinite(number)) {
    throw Unfit(fmt::format("{} is not finite; {}", value.written(), advice(parameter)));
  }
  if (!parameter.range.contains(number)) {
    throw Unfit(
        fmt::format("{} is out of range; {}", printable(value.written()), advice(parameter)));
  }
}

double interpret_number(const Parameter& parameter, const TomlValue& value) {
  if (value.type != Type::integer && value.type != Type::number) wrong_type(parameter, value);
  check_range(parameter, value, value.number);
  return value.number;
}

double interpret_integer(const Parameter& parameter, const TomlValue& value) {
  if (value.type != Type::integer) wrong_type(parameter, value);
  const std::vector<long>& allowed = parameter.allowed;
  const bool listed = std::find(allowed.begin(), allowed.end(), value.integer) != allowed.end();
  constexpr std::int64_t largest = 1'000'000'000;  // exact as a double and as a long everywhere
  if ((!allowed.empty() && !listed) || std::abs(value.number) > largest) {
    throw Unfit(fmt::format("{} is not allowed; {}", value.integer, advice(parameter)));
  }
  check_range(parameter, value, value.number);
  return value.number;
}

std::vector<std::string> names_of(const Parameter& parameter) {
  std::vector<std::string> names = parameter.choices;
  for (const auto& [name, number] : parameter.names) names.push_back(name);
  return names;
}

[[noreturn]] void unknown_word(const Parameter& parameter, const std::string& word) {
  const std::string nearest = nearest_name(word, names_of(parameter));
  throw Unfit(fmt::format("\"{}\" is not known here; needs {}{}", printable(word),
                          parameter.expectation(),
                          nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

double interpret_quantity(const Parameter& parameter, const TomlValue& value) {
  if (value.type == Type::integer || value.type == Type::number) {
    throw Unfit(fmt::format("{} has no unit; needs a unit of {}, e.g. {}", value.written(),
                            dimension_of(parameter.unit), printable(parameter.example())));
  }
  if (value.type != Type::text) wrong_type(parameter, value);
  for (const auto& [name, number] : parameter.names) {
    if (value.text == name) return number;
  }
  const bool is_word = value.text.find_first_of("0123456789") == std::string::npos;
  if (is_word && !parameter.names.empty()) unknown_word(parameter, value.text);
  try {
    const double number = parse_quantity(value.text, parameter.unit);
    check_range(parameter, value, number);
    return number;
  } catch (const UnitError& error) {
    throw Unfit(error.what());
  }
}

/// The value of a constant; zero for a formula, which is kept as a text.
double interpret_formula(const Parameter& parameter, const TomlValue& value) {
  if (value.type == Type::integer || value.type == Type::number) {
    throw Unfit(
        fmt::format("{} has no unit; needs a text with a unit of {}, e.g. {}, or a formula "
                    "of {} in SI",
                    value.written(), dimension_of(parameter.unit),
                    quoted_toml(example_of(parameter.unit)), joined(parameter.variables, " and ")));
  }
  if (value.type != Type::text) wrong_type(parameter, value);
  try {
    const Formula formula(value.text, parameter);
    if (formula.constant()) check_range(parameter, value, *formula.constant());
    return formula.constant().value_or(0);
  } catch (const FormulaError& error) {
    throw Unfit(error.what());
  }
}

void interpret_choice(const Parameter& parameter, const TomlValue& value) {
  if (value.type != Type::text) wrong_type(parameter, value);
  const std::vector<std::string>& choices = parameter.choices;
  if (std::find(choices.begin(), choices.end(), value.text) == choices.end()) {
    unknown_word(parameter, value.text);
  }
}

/// Names appear in keys, headings of tables and files, so they are words; a number would be taken
/// for a position in the list.
void interpret_name(const Parameter& parameter, const TomlValue& value) {
  if (value.type != Type::text) wrong_type(parameter, value);
  constexpr std::size_t longest = 40;
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  const std::string& name = value.text;
  const bool number = name.find_first_not_of("0123456789") == std::string::npos;
  if (name.size() > longest || !std::all_of(name.begin(), name.end(), fits) || number) {
    throw Unfit(
        fmt::format("\"{}\" is not a name; needs at most {} letters, digits, _ and -, and "
                    "no mere number",
                    printable(name), longest));
  }
}

/// Refuses a null character, at which the system would cut the path.
void interpret_file(const Parameter& parameter, const TomlValue& value) {
  if (value.type != Type::text) wrong_type(parameter, value);
  if (value.text.find('\0') != std::string::npos) {
    throw Unfit(fmt::format("\"{}\" is not a path", printable(value.text)));
  }
}

void add_item(const Parameter& parameter, const TomlValue& item, Setting& setting) {
  using Kind = Parameter::Kind;
  double number = 0;
  switch (parameter.kind) {
    case Kind::quantity:
      number = interpret_quantity(parameter, item);
      break;
    case Kind::number:
      number = interpret_number(parameter, item);
      break;
    case Kind::integer:
      number = interpret_integer(parameter, item);
      break;
    case Kind::formula:
      number = interpret_formula(parameter, item);
      break;
    case Kind::choice:
      interpret_choice(parameter, item);
      break;
    case Kind::name:
      interpret_name(parameter, item);
      break;
    case Kind::file:
      interpret_file(parameter, item);
      break;
    case Kind::boolean:
      if (item.type != Type::boolean) wrong_type(parameter, item);
      break;
    case Kind::text:
      if (item.type != Type::text) wrong_type(parameter, item);
      break;
    case Kind::any:
      if (item.type == Type::list || item.type == Type::table || item.type == Type::date)
        wrong_type(parameter, item);
      break;
  }
  setting.numbers.push_back(number);
  setting.texts.push_back(item.type == Type::text ? item.text : item.written());
}

void check_count(const Parameter& parameter, std::size_t count) {
  if (count == 0 && parameter.may_be_empty) return;
  if (count == 0) throw Unfit("the list is empty; " + advice(parameter));
  if (parameter.exact_count != 0 && count != parameter.exact_count) {
    throw Unfit(fmt::format("the list has {} items; {}", count, advice(parameter)));
  }
}

}  // namespace

Setting interpret(const Parameter& parameter, const TomlValue& value,
                  std::vector<std::string>& messages) {
  Setting setting;
  setting.written = value;
  if (parameter.may_be_auto && value.type == Type::text && value.text == "auto") {
    setting.is_auto = true;
    setting.texts = {value.text};
    return setting;
  }
  const auto attempt = [&](const auto& action) {
    try {
      action();
    } catch (const Unfit& unfit) {
      messages.push_back(unfit.what());
    }
  };
  if (!parameter.is_list) {
    attempt([&] { add_item(parameter, value, setting); });
  } else if (value.type != Type::list && parameter.one_for_all) {
    attempt([&] { add_item(parameter, value, setting); });
    setting.numbers.resize(parameter.exact_count, setting.numbers.empty() ? 0 : setting.numbers[0]);
    setting.texts.resize(parameter.exact_count, setting.texts.empty() ? "" : setting.texts[0]);
  } else if (value.type != Type::list) {
    attempt([&] { wrong_type(parameter, value); });
  } else {
    attempt([&] { check_count(parameter, value.items.size()); });
    for (const TomlValue& item : value.items) {
      attempt([&] { add_item(parameter, item, setting); });
    }
  }
  return setting;
}

Setting default_setting(const Parameter& parameter) {
  const TomlValue value = parse_toml("value = " + parameter.default_toml).front().value;
  std::vector<std::string> messages;
  Setting setting = interpret(parameter, value, messages);
  if (!messages.empty()) {
    throw std::logic_error("the default of " + parameter.key + " is invalid: " + messages.front());
  }
  setting.is_default = true;
  setting.written.line = 0;
  return setting;
}

}  // namespace zona::studies
