#include "studies/input/formula.h"

#include <fenv.h>
#include <fmt/format.h>
#include <muParser.h>

#include <cctype>
#include <charconv>
#include <cmath>

#include "studies/input/input_error.h"
#include "studies/input/units.h"

namespace zona::studies {

namespace {

/// Disables floating-point traps while it lives: an invalid operation in a user's formula gives
/// NaN, which is reported.
class QuietFloatingPoint {
 public:
  QuietFloatingPoint() { feholdexcept(&environment_); }
  ~QuietFloatingPoint() { fesetenv(&environment_); }
  QuietFloatingPoint(const QuietFloatingPoint&) = delete;
  QuietFloatingPoint& operator=(const QuietFloatingPoint&) = delete;

 private:
  fenv_t environment_;
};

enum class Form { number, quantity, formula };

/// Form of a text. A number before a letter begins a quantity, never a formula.
Form form_of(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return Form::formula;
  const char* begin = text.data() + first + (text[first] == '+' ? 1 : 0);
  double number = 0;
  const auto [rest, failure] = std::from_chars(begin, text.data() + text.size(), number);
  if (failure == std::errc::invalid_argument) return Form::formula;
  const std::size_t next = text.find_first_not_of(" \t", rest - text.data());
  if (next == std::string::npos) return number == 0 ? Form::formula : Form::number;
  const auto byte = static_cast<unsigned char>(text[next]);
  return std::isalnum(byte) != 0 || byte >= 0x80 ? Form::quantity : Form::formula;
}

std::string advice(const Parameter& parameter) {
  return fmt::format("e.g. \"{}\", or a formula of {} in SI", example_of(parameter.unit),
                     joined(parameter.variables, " and "));
}

/// muParser's message with the place counted from 1: "Unexpected token "q" found at character 3".
std::string reason(const mu::Parser::exception_type& error) {
  std::string message = error.GetMsg();
  const std::size_t position = message.find(" at position");
  if (position != std::string::npos) message.erase(position);
  while (!message.empty() && message.back() == '.') message.pop_back();
  const int at = error.GetPos();
  return at < 0 ? message : fmt::format("{} at character {}", message, at + 1);
}

/// Refuses "x = 1", which muParser takes for an assignment.
void refuse_assignment(const std::string& text) {
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
    const char before = at > 0 ? text[at - 1] : ' ';
    const bool comparison = std::string("=<>!").find(before) != std::string::npos;
    if (comparison) continue;
    if (at + 1 < text.size() && text[at + 1] == '=') {
      ++at;
      continue;
    }
    throw FormulaError(
        fmt::format("\"{}\" assigns at character {}; compare with ==", printable(text), at + 1));
  }
}

}  // namespace

struct Formula::Evaluator {
  mu::Parser parser;
  std::vector<double> values;  ///< of the variables
};

Formula::Formula(const std::string& text, const Parameter& parameter)
    : text_(text), unit_(parameter.unit), range_(parameter.range), variables_(parameter.variables) {
  const Form form = form_of(text);
  if (form == Form::number) {
    throw FormulaError(fmt::format("\"{}\" has no unit; needs a unit of {}, {}", printable(text),
                                   dimension_of(unit_), advice(parameter)));
  }
  if (form == Form::formula) {
    compile(parameter);
    return;
  }
  try {
    constant_ = parse_quantity(text, unit_);
  } catch (const UnitError& error) {
    throw FormulaError(
        fmt::format("{}, or a formula of {} in SI", error.what(), joined(variables_, " and ")));
  }
}

void Formula::compile(const Parameter& parameter) {
  refuse_assignment(text_);
  evaluator_ = std::make_shared<Evaluator>();
  evaluator_->values.resize(variables_.size());
  mu::Parser& parser = evaluator_->parser;
  const QuietFloatingPoint quiet;
  try {
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      parser.DefineVar(variables_[v], &evaluator_->values[v]);
    }
    parser.DefineConst("pi", M_PI);
    parser.SetExpr(text_);
    const double value = parser.Eval();
    if (parser.GetUsedVar().empty()) constant_ = value;
  } catch (const mu::Parser::exception_type& error) {
    throw FormulaError(fmt::format("\"{}\" is neither a quantity nor a formula: {}; needs {}",
                                   printable(text_), reason(error), advice(parameter)));
  }
  if (parser.GetNumResults() != 1) {
    throw FormulaError(
        fmt::format("\"{}\" has {} values; needs one", printable(text_), parser.GetNumResults()));
  }
  if (constant_ && !std::isfinite(*constant_)) {
    throw FormulaError(fmt::format("\"{}\" is not finite", printable(text_)));
  }
}

double Formula::at_variables(const double* values) const {
  if (constant_) return *constant_;
  std::copy(values, values + variables_.size(), evaluator_->values.begin());
  const QuietFloatingPoint quiet;
  const double value = evaluator_->parser.Eval();
  if (std::isfinite(value) && range_.contains(value)) return value;
  std::string where;
  for (std::size_t v = 0; v < variables_.size(); ++v) {
    where += fmt::format("{}{} = {:.9g}", where.empty() ? "" : ", ", variables_[v], values[v]);
  }
  const std::string allowed = std::isfinite(value) ? "; needs " + range_.text(unit_) : "";
  throw FormulaError(
      fmt::format("\"{}\" is {:g} {} at {}{}", printable(text_), value, unit_, where, allowed));
}

}  // namespace zona::studies
