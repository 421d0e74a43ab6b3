#include "studies/input/units.h"

#include <catch2/catch.hpp>

using zona::studies::parse_quantity;
using zona::studies::UnitError;

TEST_CASE("quantities are converted to SI") {
  CHECK(parse_quantity("13.5 um", "m") == 13.5e-6);
  CHECK(parse_quantity("60 us", "s") == 60e-6);
  CHECK(parse_quantity("0.6us", "s") == 0.6e-6);
  CHECK(parse_quantity("17.9 kPa", "Pa") == Approx(17900));
  CHECK(parse_quantity("63.44 GPa", "Pa") == Approx(63.44e9));
  CHECK(parse_quantity("2500 kg/m^3", "kg/m^3") == 2500);
  CHECK(parse_quantity("1 g/cm^3", "kg/m^3") == Approx(1000));
  CHECK(parse_quantity("8.9e-4 Pa s", "Pa s") == 8.9e-4);
  CHECK(parse_quantity("0 1/s", "1/s") == 0);
  CHECK(parse_quantity(" -3 nm ", "m") == -3e-9);
  CHECK(parse_quantity("+2 \u00b5m", "m") == 2e-6);
  CHECK(parse_quantity("2 \u03bcm", "m") == 2e-6);
  CHECK(parse_quantity("1 deg", "rad") == Approx(0.017453292519943295).epsilon(1e-14));
}

TEST_CASE("texts that are not quantities are refused with the reason") {
  const auto message = [](const std::string& text, const std::string& unit) -> std::string {
    try {
      parse_quantity(text, unit);
    } catch (const UnitError& error) {
      return error.what();
    }
    return "";
  };
  using Catch::Contains;
  CHECK_THAT(message("6", "m"),
             Contains("\"6\" has no unit; needs a unit of length, e.g. \"6 um\""));
  CHECK_THAT(message("6 s", "m"), Contains("is not a length; needs a unit of length"));
  CHECK_THAT(message("6 1/s", "s"), Contains("is not a time"));  // UDUNITS-2 would invert it
  CHECK_THAT(message("6 um/um", "m"), Contains("is not a length"));
  CHECK_THAT(message("6 umm", "m"), Contains("\"umm\" is not a unit"));
  CHECK_THAT(message("6 3 m", "m"), Contains("is not a unit"));
  CHECK_THAT(message("6 seconds since 1970-01-01", "s"), Contains("is not"));
  CHECK_THAT(message("six um", "m"), Contains("is not a quantity"));
  CHECK_THAT(message("", "m"), Contains("is not a quantity"));
  CHECK_THAT(message("1e999 m", "m"), Contains("not a finite number"));
  CHECK_THAT(message("inf m", "m"), Contains("not a finite number"));
  CHECK_THAT(message("nan m", "m"), Contains("not a finite number"));
  CHECK_THAT(message("1e308 km", "m"), Contains("not finite"));
  CHECK_THAT(message("1 " + std::string(10000, 'm'), "m"), Contains("(10000 characters)"));
  CHECK_THAT(message(std::string("1 m\0m", 5), "m"), Contains("is not a unit"));
  CHECK_THAT(message("1 ((((m", "m"), Contains("is not a unit"));
}
