#include "studies/input/units.h"

#include <fmt/format.h>
#include <udunits2.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include "studies/input/input_error.h"

namespace zona::studies {

namespace {

struct Dimension {
  const char* unit;
  const char* name;
  const char* example;
};

constexpr Dimension dimensions[] = {
    {"m", "length", "6 um"},          {"s", "time", "60 us"},
    {"Pa", "pressure", "17.9 kPa"},   {"kg/m^3", "density", "1000 kg/m^3"},
    {"Pa s", "viscosity", "1 mPa s"}, {"1/s", "rate", "10 1/s"},
    {"m/s", "velocity", "0.1 m/s"},   {"rad", "angle", "1 deg"},
    {"N", "force", "0.5 uN"},         {"Hz", "frequency", "2 Hz"},
    {"m^2", "area", "1 mm^2"},        {"m/s^2", "acceleration", "-9.81 m/s^2"},
};

const Dimension* find_dimension(const std::string& si_unit) {
  for (const Dimension& dimension : dimensions) {
    if (si_unit == dimension.unit) return &dimension;
  }
  return nullptr;
}

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

/// The unit database, read once. Callers hold `library`, because UDUNITS-2 keeps global state.
std::mutex library;
ut_system* unit_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    ut_system* const result = ut_read_xml(nullptr);
    const Unit degree(result ? ut_parse(result, "arc_degree", UT_ASCII) : nullptr);
    if (degree) ut_map_name_to_unit("deg", UT_ASCII, degree.get());
    return result;
  }();
  if (system == nullptr) {
    throw UnitError(
        "the unit database of UDUNITS-2 cannot be read; install Debian's libudunits2-data");
  }
  return system;
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Replaces the micro signs of Unicode, which UDUNITS-2 does not accept everywhere.
std::string with_ascii_micro(std::string_view text) {
  std::string result(text);
  for (const char* micro : {"\u00b5", "\u03bc"}) {
    for (std::size_t at; (at = result.find(micro)) != std::string::npos;)
      result.replace(at, 2, "u");
  }
  return result;
}

Unit parse_unit(const std::string& text, const std::string& wanted) {
  const char first = text.front();
  const bool number_again = (first >= '0' && first <= '9' && text.rfind("1/", 0) != 0) ||
                            first == '+' || first == '-' || first == '.';
  constexpr std::size_t longest = 80;
  Unit unit;
  const bool whole = text.find('\0') == std::string::npos;
  if (!number_again && whole && text.size() <= longest) {
    unit.reset(ut_parse(unit_system(), text.c_str(), UT_UTF8));
  }
  if (!unit) {
    throw UnitError(fmt::format("\"{}\" is not a unit; needs a unit of {}, e.g. \"{}\"",
                                printable(text), dimension_of(wanted), example_of(wanted)));
  }
  return unit;
}

/// UDUNITS-2 also converts between reciprocal units (s and 1/s); a study must not.
bool same_dimension(const ut_unit* a, const ut_unit* b) {
  const Unit ratio(ut_divide(a, b));
  return ratio && ut_is_dimensionless(ratio.get()) && ut_are_convertible(a, b);
}

/// Decimal number times 10^power, rounded once.
double shifted(const std::string& number, int power) {
  const std::size_t exponent_at = number.find_first_of("eE");
  int exponent = 0;
  if (exponent_at != std::string::npos) {
    const std::size_t digits = exponent_at + (number[exponent_at + 1] == '+' ? 2 : 1);
    std::from_chars(number.data() + digits, number.data() + number.size(), exponent);
  }
  const std::string text = fmt::format("{}e{}", number.substr(0, exponent_at), exponent + power);
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

double convert(const std::string& number, double value, const ut_unit* from, const ut_unit* to) {
  const Converter converter(ut_get_converter(const_cast<ut_unit*>(from), const_cast<ut_unit*>(to)));
  if (!converter) throw UnitError("the unit cannot be converted to SI");
  const double offset = cv_convert_double(converter.get(), 0);
  const double factor = cv_convert_double(converter.get(), 1) - offset;
  const double power = std::round(std::log10(factor));
  // Multiplying 60 by a rounded 1e-6 would round twice; moving the decimal point rounds once.
  const bool decimal = offset == 0 && factor > 0 && std::abs(power) < 100 &&
                       std::abs(factor * std::pow(10, -power) - 1) < 1e-14;
  return decimal ? shifted(number, static_cast<int>(power))
                 : cv_convert_double(converter.get(), value);
}

}  // namespace

double parse_quantity(std::string_view text, const std::string& si_unit) {
  const std::string_view quantity = without_blanks(text);
  const char* const end = quantity.data() + quantity.size();
  double number = 0;
  const bool plus = !quantity.empty() && quantity.front() == '+';
  const auto [rest, failure] = std::from_chars(quantity.data() + plus, end, number);
  if (failure == std::errc::invalid_argument) {
    throw UnitError(
        fmt::format("\"{}\" is not a quantity; needs a number and a unit of {}, e.g. \"{}\"",
                    printable(text), dimension_of(si_unit), example_of(si_unit)));
  }
  if (failure == std::errc::result_out_of_range || !std::isfinite(number)) {
    throw UnitError(fmt::format(
        "\"{}\" is not a finite number; needs one that fits double precision", printable(text)));
  }
  const std::string unit_text =
      with_ascii_micro(without_blanks({rest, static_cast<std::size_t>(end - rest)}));
  if (unit_text.empty()) {
    throw UnitError(fmt::format("\"{}\" has no unit; needs a unit of {}, e.g. \"{}\"",
                                printable(text), dimension_of(si_unit), example_of(si_unit)));
  }
  const std::lock_guard<std::mutex> lock(library);
  const Unit wanted(ut_parse(unit_system(), si_unit.c_str(), UT_UTF8));
  const Unit unit = parse_unit(unit_text, si_unit);
  if (!wanted) throw UnitError("\"" + si_unit + "\" is not a unit");
  if (!same_dimension(unit.get(), wanted.get())) {
    throw UnitError(fmt::format("\"{}\" is not a {}; needs a unit of {}, e.g. \"{}\"",
                                printable(text), dimension_of(si_unit), dimension_of(si_unit),
                                example_of(si_unit)));
  }
  const double value = convert({quantity.data() + plus, rest}, number, unit.get(), wanted.get());
  if (!std::isfinite(value)) {
    throw UnitError(fmt::format("\"{}\" is not finite in {}", printable(text), si_unit));
  }
  return value;
}

std::string dimension_of(const std::string& si_unit) {
  const Dimension* dimension = find_dimension(si_unit);
  return dimension ? dimension->name : si_unit;
}

std::string example_of(const std::string& si_unit) {
  const Dimension* dimension = find_dimension(si_unit);
  return dimension ? dimension->example : "1 " + si_unit;
}

}  // namespace zona::studies
