#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace zona::studies {

/// A text is not a finite quantity of the wanted dimension; what() says why, in the user's words.
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Value in `si_unit` of a quantity such as "13.5 um" or "0 1/s", by UDUNITS-2. A power-of-ten
/// prefix is applied without rounding: "60 us" is exactly 60e-6. Safe to call from any thread.
/// Throws UnitError when the text has no number, no unit, an unknown unit or one of another
/// dimension, or is not finite.
double parse_quantity(std::string_view text, const std::string& si_unit);

/// What a unit measures: "length" for "m"; the unit itself when it has no common name.
std::string dimension_of(const std::string& si_unit);

/// An example of a quantity in that unit: "6 um" for "m".
std::string example_of(const std::string& si_unit);

}  // namespace zona::studies
