#include "studies/kinds/piercing/failure_pattern.h"

#include <catch2/catch.hpp>

using namespace zona;
using studies::failure_pattern;

namespace {

/// A sheet in the y-z plane around the tip, of which the points that `failed` names have failed.
template <class Failed>
studies::FailurePattern pattern_of(Failed failed) {
  const auto sheet = mpm::sheet({0, -2, -2}, {0, 4, 0}, {0, 0, 4}, 81, 81);
  const auto points =
      mpm::make_points(sheet.places, std::vector<double>(sheet.places.size(), 1e-3));
  mpm::Membrane zona({1100, 1e-3, 1e4, 0.3}, mpm::Elastic{}, false, points, sheet.triangles);
  for (std::size_t p = 0; p < sheet.places.size(); ++p) {
    if (failed(sheet.places[p].y(), sheet.places[p].z())) zona.integrity.left[p] = 0;
  }
  return failure_pattern(zona, sheet.places, {{0, 0, 0}, {1, 0, 0}, 1, 0.4, 0.5});
}

}  // namespace

TEST_CASE("a failure pattern distinguishes bands, corners and rings") {
  const auto none = pattern_of([](double, double) { return false; });
  CHECK(none.y_high == 0);
  CHECK(none.mean_distance == 0);

  const auto band =
      pattern_of([](double y, double z) { return std::abs(y) < 1.51 && std::abs(z) < 0.21; });
  CHECK(band.y_low == Approx(-1.5));
  CHECK(band.y_high == Approx(1.5));
  CHECK(band.z_high == Approx(0.2));
  CHECK(band.share_along == Approx(1));

  const auto corners = pattern_of([](double y, double z) {
    return std::abs(std::abs(y) - 1) < 0.11 && std::abs(std::abs(z) - 1) < 0.11;
  });
  CHECK(corners.share_diagonal == Approx(1));
  CHECK(corners.share_under_tip == 0);
  CHECK(corners.mean_distance == Approx(std::sqrt(2.)).epsilon(0.01));

  // A lattice of 1/20 resolves the sectors of a ring of radius 1.5 to a few percent.
  const auto ring = pattern_of([](double y, double z) {
    const double r = std::hypot(y, z);
    return r > 1 && r < 1.9;
  });
  for (const double share : {ring.share_along, ring.share_diagonal, ring.share_across}) {
    CHECK(share == Approx(1. / 3).margin(0.02));
  }
}
