#include "mpm/results/diagnostics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mpm/points/errors.h"

namespace zona::mpm {

namespace {

double stored_energy(const Fluid& m, const MaterialPoints& points, int p) {
  return points.mass[p] * (m.internal_energy[p] - m.initial_energy);
}

/// sigma : C^-1 : sigma / 2 times the volume [J].
double elastic_energy(const SymmetricTensorField& stress, const ElasticModuli& moduli,
                      double volume, int p) {
  double trace = 0;
  double square = 0;
  for (int c = 0; c < 6; ++c) {
    const double s = stress[c][p];
    trace += c < 3 ? s : 0;
    square += (c < 3 ? 1 : 2) * s * s;
  }
  const double nu = moduli.poisson_ratio;
  return ((1 + nu) * square - nu * trace * trace) / (2 * moduli.youngs_modulus) * volume;
}

template <class Law>
double stored_energy(const Solid<Law>& m, const MaterialPoints& points, int p) {
  return elastic_energy(m.stress, m.properties.moduli(), points.mass[p] / m.density[p], p);
}

double stored_energy(const Solid<Elastodamage>& m, const MaterialPoints& points, int p) {
  return m.state.integrity[p] * elastic_energy(m.state.effective_stress, m.properties.moduli(),
                                               points.mass[p] / m.density[p], p);
}

double stored_energy(const Membrane& m, const MaterialPoints& points, int p) {
  return m.energy_density[p] * points.mass[p] / m.properties.density;
}

double stored_energy(const Prescribed&, const MaterialPoints&, int) {
  return 0;
}

}  // namespace

BodyTotals totals(const Body& body) {
  const std::vector<int> in_order = body.points.storage_by_id();
  BodyTotals sum;
  std::visit(
      [&](const auto& material) {
        for (int p : in_order) {
          const Eigen::Vector3d v = body.points.velocity_of(p);
          const double m = body.points.mass[p];
          sum.mass += m;
          sum.momentum += m * v;
          sum.kinetic_energy += 0.5 * m * v.squaredNorm();
          sum.stored_energy += stored_energy(material, body.points, p);
        }
      },
      body.material);
  return sum;
}

Eigen::Vector3d first_moment(const Body& body) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int p : body.points.storage_by_id()) {
    sum += body.points.mass[p] * body.points.position_of(p);
  }
  return sum;
}

double specific_energy(const Body& body, int p) {
  if (const auto* fluid = std::get_if<Fluid>(&body.material)) return fluid->internal_energy[p];
  return std::visit(
      [&](const auto& material) {
        return stored_energy(material, body.points, p) / body.points.mass[p];
      },
      body.material);
}

BodyTotals totals(const std::vector<Body>& bodies) {
  BodyTotals sum;
  for (const Body& body : bodies) sum += totals(body);
  return sum;
}

PressureRange cell_averaged_pressure(const Body& body) {
  const auto* fluid = std::get_if<Fluid>(&body.material);
  if (!fluid) throw ModelError("body '" + body.name + "' is not a fluid and has no pressure");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto pressure = [&](int p) {
    return -(fluid->stress[0][p] + fluid->stress[1][p] + fluid->stress[2][p]) / 3;
  };
  PressureRange range{infinity, -infinity, 0};
  double squares = 0;
  double whole = 0;
  for (int b = 0; b < body.cells.brick_count(); ++b) {
    const BrickPoints& brick = body.cells.brick(b);
    for (int c = 0; c < Brick::cell_count; ++c) {
      if (brick.begin[c] == brick.begin[c + 1]) continue;
      double force = 0;
      double volume = 0;
      for (int n = brick.begin[c]; n < brick.begin[c + 1]; ++n) {
        const int p = brick.points[n];
        const double v = body.points.mass[p] / fluid->density[p];
        force += v * pressure(p);
        volume += v;
      }
      for (int n = brick.begin[c]; n < brick.begin[c + 1]; ++n) {
        const int p = brick.points[n];
        squares +=
            body.points.mass[p] / fluid->density[p] * std::pow(pressure(p) - force / volume, 2);
      }
      whole += volume;
      range.lowest = std::min(range.lowest, force / volume);
      range.highest = std::max(range.highest, force / volume);
    }
  }
  range.scatter = whole > 0 ? std::sqrt(squares / whole) : 0;
  return range;
}

double cell_averaged_shear_rate(const Body& body) {
  const auto* fluid = std::get_if<Fluid>(&body.material);
  if (!fluid) throw ModelError("body '" + body.name + "' is not a fluid and has no shear rate");
  if (!(fluid->properties.shear_viscosity > 0)) return 0;
  double largest = 0;
  for (int b = 0; b < body.cells.brick_count(); ++b) {
    const BrickPoints& brick = body.cells.brick(b);
    for (int c = 0; c < Brick::cell_count; ++c) {
      if (brick.begin[c] == brick.begin[c + 1]) continue;
      std::array<double, 6> sum{};
      double volume = 0;
      for (int n = brick.begin[c]; n < brick.begin[c + 1]; ++n) {
        const int p = brick.points[n];
        const double v = body.points.mass[p] / fluid->density[p];
        for (int i = 0; i < 6; ++i) sum[i] += v * fluid->stress[i][p];
        volume += v;
      }
      const double mean = (sum[0] + sum[1] + sum[2]) / 3;
      double squares = 0;  // s : s
      for (int i = 0; i < 3; ++i) squares += std::pow(sum[i] - mean, 2);
      for (int i = 3; i < 6; ++i) squares += 2 * sum[i] * sum[i];
      largest =
          std::max(largest, std::sqrt(squares / 2) / volume / fluid->properties.shear_viscosity);
    }
  }
  return largest;
}

}  // namespace zona::mpm
