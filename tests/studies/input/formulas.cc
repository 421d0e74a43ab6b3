#include <catch2/catch.hpp>
#include <cmath>

#include "studies/input/formula.h"

using namespace zona::studies;
using Catch::Contains;

namespace {

Parameter speed(const std::vector<std::string>& variables, const std::string& interval = "") {
  Parameter parameter;
  parameter.key = "body.velocity";
  parameter.kind = Parameter::Kind::formula;
  parameter.unit = "m/s";
  parameter.variables = variables;
  if (!interval.empty()) parameter.in(interval);
  return parameter;
}

double at_time(const std::string& text, double time) {
  return Formula(text, speed({"t"})).at(time);
}

}  // namespace

TEST_CASE("a formula of time or place is evaluated in SI") {
  CHECK(at_time("3*t^2 - 1", 2) == 11);
  CHECK(at_time("sin(2*pi*t)", 0.25) == Approx(1));
  CHECK(at_time("t < 5e-6 ? 1e5*t : 0.5", 4e-6) == Approx(0.4));
  CHECK(at_time("t < 5e-6 ? 1e5*t : 0.5", 6e-6) == 0.5);
  CHECK(at_time("t == 1 ? 2 : 3", 1) == 2);
  const Formula field("x + 10*y + 100*z", speed({"x", "y", "z"}));
  CHECK(field.at(Eigen::Vector3d(1, 2, 3)) == 321);
  CHECK_FALSE(field.constant());
}

TEST_CASE("a quantity with a unit, zero, and a formula without variables are constants") {
  CHECK(Formula("10 mm/s", speed({"t"})).constant() == 0.01);
  CHECK(Formula(" -2.5km/h", speed({"t"})).at(7) == Approx(-2.5 / 3.6));
  CHECK(Formula("0", speed({"t"})).constant() == 0.0);
  CHECK(Formula("2*pi", speed({"t"})).constant() == 2 * M_PI);
  CHECK(Formula("5 \u00b5m/s", speed({"t"})).constant() == 5e-6);
}

TEST_CASE("invalid formulas are refused with the place of the error") {
  const auto refused = [](const std::string& text) {
    try {
      Formula(text, speed({"x", "y", "z"}));
      return std::string();
    } catch (const FormulaError& error) {
      return std::string(error.what());
    }
  };
  CHECK_THAT(refused("10"), Contains("\"10\" has no unit; needs a unit of velocity, e.g. \"0.1 "
                                     "m/s\", or a formula of x, y and z in SI"));
  CHECK_THAT(refused("10 m/ss"), Contains("\"m/ss\" is not a unit"));
  CHECK_THAT(refused("10 m"), Contains("is not a velocity"));
  CHECK_THAT(refused("2*q"), Contains("\"2*q\" is neither a quantity nor a formula") &&
                                 Contains("\"q\"") && Contains("at character 3"));
  CHECK_THAT(refused("sin(x"), Contains("Missing parenthesis"));
  CHECK_THAT(refused("2*t"), Contains("\"t\"") && Contains("character 3"));
  CHECK_THAT(refused("x = 1"), Contains("assigns at character 3; compare with =="));
  CHECK_THAT(refused("x, y"), Contains("2 values; needs one"));
  CHECK_THAT(refused(""), Contains("neither a quantity nor a formula"));
  CHECK_THAT(refused("\"a\""), Contains("neither a quantity nor a formula"));
  CHECK_THAT(refused("1/0"), Contains("is not finite"));
  CHECK_THAT(refused("sqrt(-1)"), Contains("is not finite"));
  CHECK_THAT(refused("1e999 m/s"), Contains("not a finite number"));
  CHECK(refused(std::string(5000, '(')).size() < 400);
}

TEST_CASE("values that are not finite or out of range name the place") {
  const Formula root("sqrt(x)", speed({"x", "y", "z"}));
  CHECK(root.at(Eigen::Vector3d(4, 0, 0)) == 2);
  CHECK_THROWS_WITH(root.at(Eigen::Vector3d(-4, 1, 0)),
                    Contains("is nan m/s at x = -4, y = 1, z = 0") ||
                        Contains("is -nan m/s at x = -4, y = 1, z = 0"));
  const Formula limited("5 - t", speed({"t"}, "(0, 10]"));
  CHECK(limited.at(1.0) == 4);
  CHECK_THROWS_WITH(limited.at(6.0), Contains("\"5 - t\" is -1 m/s at t = 6; needs above 0 m/s and "
                                              "at most 10 m/s"));
}
