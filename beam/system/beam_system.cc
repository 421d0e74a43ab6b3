#include "beam/system/beam_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "beam/system/elements_library.h"

namespace zona::beam {

namespace {

/// Chebyshev points in the logarithm of the radius, between two radii; one point for equal radii.
std::vector<double> radius_nodes(Flow flow, double least, double greatest) {
  const double span = std::log(greatest / least);
  if (span < 1e-12) return {least};
  // Viscous loads are smooth in ln a, less so in a bore, whose poles are near. With this number of
  // points they err by 1e-5, in a bore by 1e-4.
  const int per_span = flow == Flow::within ? 5 : 2;
  const int count = 4 + static_cast<int>(std::ceil(per_span * span));
  std::vector<double> nodes;
  for (int k = 0; k < count; ++k)
    nodes.push_back(least * std::exp(span / 2 * (1 - std::cos(M_PI * (k + 0.5) / count))));
  return nodes;
}

/// Lagrange polynomial k of ln a over the nodes.
double lagrange(const std::vector<double>& nodes, std::size_t k, double radius) {
  double value = 1;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (i != k) value *= std::log(radius / nodes[i]) / std::log(nodes[k] / nodes[i]);
  return value;
}

/// Adds the viscous loads of one liquid on quadrature points, for walls with radius(x).
void add_viscous_loads(const ViscousLoad& kind, const std::vector<QuadraturePoint>& points,
                       const std::function<double(double)>& radius, int size,
                       LiquidLoads& liquids) {
  if (points.empty()) return;
  double least = radius(points.front().x), greatest = least;
  for (const QuadraturePoint& point : points) {
    least = std::min(least, radius(point.x));
    greatest = std::max(greatest, radius(point.x));
  }
  const std::vector<double> nodes = radius_nodes(kind.flow, least, greatest);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    ViscousLoad load = kind;
    load.radius = nodes[k];
    load.share = distribute(points, size, [&](double x) { return lagrange(nodes, k, radius(x)); });
    liquids.viscous.push_back(std::move(load));
  }
}

template <class Condition>
std::vector<QuadraturePoint> points_where(const std::vector<QuadraturePoint>& points,
                                          const Condition& condition) {
  std::vector<QuadraturePoint> chosen;
  std::copy_if(points.begin(), points.end(), std::back_inserter(chosen), condition);
  return chosen;
}

double outer_radius(const Pipette& pipette, double x) {
  return diameters_at(pipette, x).outer / 2;
}

/// Adds the viscous loads of the bath and returns the immersed points.
std::vector<QuadraturePoint> add_bath(const Pipette& pipette, Flow flow,
                                      const std::vector<QuadraturePoint>& points, int size,
                                      LiquidLoads& liquids) {
  const Bath& bath = pipette.bath;
  if (bath.model == BathModel::none) return {};
  const double from = immersed_from(pipette);
  std::vector<QuadraturePoint> immersed =
      points_where(points, [&](const QuadraturePoint& point) { return point.x >= from; });
  ViscousLoad kind{flow, bath.liquid, 0, bath.model, 2 * M_PI * bath.frequency, {}};
  add_viscous_loads(
      kind, immersed, [&](double x) { return outer_radius(pipette, x); }, size, liquids);
  return immersed;
}

/// Loads of the bath on a pipette that moves across its axis.
LiquidLoads liquids_across(const Pipette& pipette, const std::vector<QuadraturePoint>& points,
                           int size) {
  LiquidLoads liquids;
  const std::vector<QuadraturePoint> immersed =
      add_bath(pipette, Flow::across, points, size, liquids);
  if (!liquids.act()) return liquids;
  const Bath& bath = pipette.bath;
  liquids.displaced = distribute(immersed, size, [&](double x) {
    const double radius = outer_radius(pipette, x);
    return bath.liquid.density * M_PI * radius * radius;
  });
  if (bath.drag_coefficient > 0) {
    liquids.drag = immersed;
    for (QuadraturePoint& point : liquids.drag)
      point.weight *= bath.liquid.density * bath.drag_coefficient * outer_radius(pipette, point.x);
  }
  return liquids;
}

/// Loads of bath and fill on a pipette that moves along its axis.
LiquidLoads liquids_along(const Pipette& pipette, const std::vector<QuadraturePoint>& points,
                          int size) {
  LiquidLoads liquids;
  add_bath(pipette, Flow::along, points, size, liquids);
  const auto bore = [&](double x) { return diameters_at(pipette, x).inner / 2; };
  std::vector<QuadraturePoint> filled = points_where(points, [&](const QuadraturePoint& point) {
    return bore(point.x) > 0 && fill_at(pipette, point.x).density > 0;
  });
  while (!filled.empty()) {  // one fluid after the other
    const Liquid fluid = fill_at(pipette, filled.front().x);
    const auto has_fluid = [&](const QuadraturePoint& point) {
      const Liquid here = fill_at(pipette, point.x);
      return here.density == fluid.density && here.viscosity == fluid.viscosity;
    };
    add_viscous_loads({Flow::within, fluid, 0, BathModel::frequency, 0, {}},
                      points_where(filled, has_fluid), bore, size, liquids);
    filled.erase(std::remove_if(filled.begin(), filled.end(), has_fluid), filled.end());
  }
  if (liquids.act()) liquids.displaced = {SymmetricBand(size), Eigen::VectorXd::Zero(size)};
  return liquids;
}

BeamSystem system_of(const Pipette& pipette, const Section& section, const BeamLayout& layout) {
  BeamSystem system = assemble(section, layout);
  system.damping_alpha = pipette.damping_alpha;
  system.damping_beta = pipette.damping_beta;
  system.loss_factor = pipette.loss_factor;
  system.loss_frequency = 2 * M_PI * pipette.loss_frequency;
  const bool bends = layout.deformation == Deformation::bending;
  if (bends && pipette.bath.model == BathModel::none) return system;  // the fill only adds mass
  const std::vector<QuadraturePoint> points = quadrature_points(section, layout);
  system.liquids = bends ? liquids_across(pipette, points, system.size())
                         : liquids_along(pipette, points, system.size());
  return system;
}

}  // namespace

BeamSystem assemble(const Section& section, const BeamLayout& layout) {
  BeamSystem system;
  elements_library().assemble(section, layout, system);
  return system;
}

std::vector<QuadraturePoint> quadrature_points(const Section& section, const BeamLayout& layout) {
  std::vector<QuadraturePoint> points;
  elements_library().quadrature_points(section, layout, points);
  return points;
}

Distributed distribute(const std::vector<QuadraturePoint>& points, int size,
                       const std::function<double(double)>& coefficient) {
  Distributed sum{SymmetricBand(size), Eigen::VectorXd::Zero(size)};
  for (const QuadraturePoint& point : points) {
    const double value = point.weight * coefficient(point.x);
    for (int i = 0; i < QuadraturePoint::dofs; ++i) {
      const int row = point.dof[i];
      if (row == QuadraturePoint::held) continue;
      sum.support(row) += value * point.shape[i] * point.rigid;
      for (int j = 0; j < QuadraturePoint::dofs; ++j)
        if (point.dof[j] != QuadraturePoint::held && point.dof[j] <= row)
          sum.matrix.add(row, point.dof[j], value * point.shape[i] * point.shape[j]);
    }
  }
  return sum;
}

BeamSystem cantilever(const Pipette& pipette) {
  return system_of(pipette, section_of(pipette),
                   {pipette.elements, Supports::clamped_free, pipette.length});
}

BeamSystem axial_rod(const Pipette& pipette) {
  Section section = section_of(pipette);
  section.mass_per_length = [pipette](double x) {
    return pipette.density * glass_area(diameters_at(pipette, x));
  };
  section.axial_rigidity = [pipette](double x) {
    return pipette.youngs_modulus * glass_area(diameters_at(pipette, x));
  };
  return system_of(
      pipette, section,
      {pipette.elements, Supports::clamped_free, pipette.length, Deformation::stretching});
}

BeamSystem simply_supported(const Pipette& pipette) {
  return system_of(pipette, section_of(pipette),
                   {pipette.elements, Supports::pinned_pinned, pipette.length / 2});
}

}  // namespace zona::beam
