#include "studies/references/profile_errors.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mpm/points/errors.h"

using namespace zona::studies::references;
using zona::mpm::ModelError;

TEST_CASE("errors of a profile are averages over its length") {
  // Off by 1 on a length of 3 and by 2 on a length of 1.
  const auto e = profile_errors({{0, 1, 3}, {1, 3, 1}}, [](double x) { return x; });
  CHECK(e.l1 == Approx((3 * 1 + 1 * 2) / 4.0));
  CHECK(e.l2 == Approx(std::sqrt((3 * 1 + 1 * 4) / 4.0)));
  CHECK(e.largest == 2);
  const auto scaled = profile_errors({{0, 1, 30}, {1, 3, 10}}, [](double x) { return x; });
  CHECK(scaled.l1 == Approx(e.l1));
  CHECK_THROWS_AS(profile_errors({}, [](double) { return 0.0; }), ModelError);
  CHECK_THROWS_AS(profile_errors({{0, 1, 0}}, [](double) { return 0.0; }), ModelError);
}

TEST_CASE("the observed order is the exponent of a power law") {
  CHECK(observed_order({0.1, 0.05, 0.02}, {3e-2, 7.5e-3, 1.2e-3}) == Approx(2));
  CHECK(observed_order({1, 2}, {1, 2}) == Approx(1));
  // The least-squares line through points off a straight one: slope -1/2 of 0, 1, -1 at 0, 1, 2.
  const double e = std::exp(1.0);
  CHECK(observed_order({1, e, e * e}, {1, e, 1 / e}) == Approx(-0.5));
  CHECK_THROWS_AS(observed_order({1}, {1}), ModelError);
  CHECK_THROWS_AS(observed_order({1, 1}, {1, 2}), ModelError);
  CHECK_THROWS_AS(observed_order({1, 2}, {1, 0}), ModelError);
  CHECK_THROWS_AS(observed_order({1, 2}, {1, 2, 3}), ModelError);
}

TEST_CASE("extrapolation removes the leading error") {
  const auto value = [](double h) { return 5 - 3 * h * h; };
  CHECK(extrapolated(0.2, value(0.2), 0.1, value(0.1), 2) == Approx(5).epsilon(1e-14));
  CHECK_THROWS_AS(extrapolated(0.1, 1, 0.2, 1, 2), ModelError);
}
