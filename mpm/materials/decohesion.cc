#include "mpm/materials/decohesion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mpm/points/errors.h"

namespace zona::mpm {

void check(const Decohesion& m) {
  if (!(m.reference_opening > 0) || !(m.mode_ratio > 0) || !(m.cell.minCoeff() > 0)) {
    throw ModelError(fmt::format(
        "decohesion needs a positive reference opening, ratio of strengths and cell, got {} m, "
        "{}, {} m",
        m.reference_opening, m.mode_ratio, m.cell.minCoeff()));
  }
  if (!(m.exponent >= 1)) {
    throw ModelError(
        fmt::format("the exponent of decohesion must be at least 1, got {}: with less, "
                    "the strength would initially drop vertically",
                    m.exponent));
  }
  if (!(m.reference_traction >= 0)) {
    throw ModelError(fmt::format("the reference traction must not be negative, got {} Pa",
                                 m.reference_traction));
  }
}

/// The area of the plane is the volume times the probability density, at zero, of the sum of three
/// uniform random numbers from intervals as long as the cell's edges along n.
double effective_length(const Eigen::Vector3d& normal, const Eigen::Vector3d& cell) {
  Eigen::Vector3d w = normal.cwiseProduct(cell).cwiseAbs();
  std::sort(w.data(), w.data() + 3);
  const double beyond = w[0] + w[1] - w[2];
  if (beyond <= 0) return w[2];
  return w[2] / (1 - beyond * beyond / (4 * w[0] * w[1]));
}

DecohesionSurface surface_at(const Decohesion& m, const SurfaceVector& t) {
  const double opening = std::max(t.normal, 0.0);
  const double tensile = std::hypot(opening, t.tangential / m.mode_ratio);
  const double reference =
      m.reference_traction > 0 ? m.reference_traction : std::hypot(opening, t.tangential);
  return {tensile, reference};
}

DecohesionFlow decohesion_flow(const Decohesion& m, const DecohesionSurface& surface,
                               const SurfaceVector& t) {
  const double shear_strength = m.mode_ratio * surface.tensile_strength;
  const double a = std::max(t.normal, 0.0) / surface.tensile_strength;
  const double b = t.tangential > 1e-12 * t.normal ? t.tangential / shear_strength : 0;
  const double size = std::hypot(a, b);
  if (!(size > 0)) return {{0, 0}, 0};
  const double scale = m.reference_opening * surface.reference_traction;
  return {{scale * a / size / surface.tensile_strength, scale * b / size / shear_strength},
          scale * size};
}

double decohesion_increment(const Decohesion& m, const DecohesionSurface& surface, double lambda,
                            double effective, double relief, double at_axis) {
  const double initial = m.reference_opening * surface.reference_traction;  // U_0
  const double excess = effective - initial * (1 - std::pow(lambda, m.exponent));
  constexpr double tolerance = 1e-10;  // of U_0
  if (!(excess > tolerance * initial)) return 0;
  const double loss = initial * m.exponent * std::pow(lambda, m.exponent - 1);
  if (!(relief > loss)) return 1 - lambda;
  return std::min({1 - lambda, excess / (relief - loss), at_axis});
}

double longest_resolved_length(const Decohesion& m, const DecohesionSurface& surface,
                               const SurfaceVector& traction, const SurfaceVector& stiffness) {
  const auto [normal, tangential] = decohesion_flow(m, surface, traction).direction;
  const double resistance =
      stiffness.normal * normal * normal + stiffness.tangential * tangential * tangential;
  return resistance / (m.reference_opening * surface.reference_traction * m.exponent);
}

}  // namespace zona::mpm
