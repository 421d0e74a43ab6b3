#include "beam/beam_system.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "beam/elements/elements.h"

namespace zona::beam {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// What the library next to this one offers.
struct Elements {
  decltype(&zona_beam_assemble) assemble;
  decltype(&zona_beam_quadrature_points) quadrature_points;
};

template <class Function>
Function find_function(void* library, const char* name) {
  void* const function = library != nullptr ? dlsym(library, name) : nullptr;
  if (function == nullptr)
    throw std::runtime_error(
        fmt::format("the beam's finite elements cannot be loaded: {}; install Zona and deal.II "
                    "again",
                    dlerror()));
  return reinterpret_cast<Function>(function);
}

/// Of the file that holds this function, with a slash; empty if the loader does not know.
std::string own_folder() {
  Dl_info self{};
  if (dladdr(reinterpret_cast<void*>(&own_folder), &self) == 0 || self.dli_fname == nullptr)
    return "";
  const std::string file = self.dli_fname;
  return file.substr(0, file.rfind('/') + 1);
}

const Elements& elements() {
  static const Elements functions = [] {
    void* const library =
        dlopen((own_folder() + "libzona_beam_elements.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    return Elements{find_function<decltype(&zona_beam_assemble)>(library, "zona_beam_assemble"),
                    find_function<decltype(&zona_beam_quadrature_points)>(
                        library, "zona_beam_quadrature_points")};
  }();
  return functions;
}

/// Chebyshev points between two radii, evenly in the angle of their logarithm; one for equal radii.
std::vector<double> radius_nodes(double least, double greatest) {
  const double span = std::log(greatest / least);
  if (span < 1e-12) return {least};
  // Viscous loads are smooth in ln a: this many keep them to 1e-5.
  const int count = 4 + static_cast<int>(std::ceil(2 * span));
  std::vector<double> nodes;
  for (int k = 0; k < count; ++k)
    nodes.push_back(least * std::exp(span / 2 * (1 - std::cos(kPi * (k + 0.5) / count))));
  return nodes;
}

/// Lagrange's polynomial k of ln a over the nodes.
double lagrange(const std::vector<double>& nodes, std::size_t k, double radius) {
  double value = 1;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (i != k) value *= std::log(radius / nodes[i]) / std::log(nodes[k] / nodes[i]);
  return value;
}

Immersion immersion_of(const Pipette& pipette, const Section& section, const BeamLayout& layout,
                       int size) {
  const Bath& bath = pipette.bath;
  Immersion immersion;
  if (bath.model == BathModel::none) return immersion;
  std::vector<QuadraturePoint> points = quadrature_points(section, layout);
  const double from = immersed_from(pipette);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const QuadraturePoint& point) { return point.x < from; }),
               points.end());
  if (points.empty()) return immersion;
  const auto radius = [&](double x) { return diameters_at(pipette, x).outer / 2; };
  double least = radius(points.front().x), greatest = least;
  for (const QuadraturePoint& point : points) {
    least = std::min(least, radius(point.x));
    greatest = std::max(greatest, radius(point.x));
  }
  immersion.model = bath.model;
  immersion.liquid = bath.liquid;
  immersion.angular_frequency = 2 * kPi * bath.frequency;
  immersion.radius = radius_nodes(least, greatest);
  for (std::size_t k = 0; k < immersion.radius.size(); ++k)
    immersion.share.push_back(distribute(
        points, size, [&](double x) { return lagrange(immersion.radius, k, radius(x)); }));
  immersion.displaced = distribute(
      points, size, [&](double x) { return bath.liquid.density * kPi * radius(x) * radius(x); });
  if (bath.drag_coefficient > 0) {
    immersion.drag = points;
    for (QuadraturePoint& point : immersion.drag)
      point.weight *= bath.liquid.density * bath.drag_coefficient * radius(point.x);
  }
  return immersion;
}

BeamSystem system_of(const Pipette& pipette, const Section& section, const BeamLayout& layout) {
  BeamSystem system = assemble(section, layout);
  system.damping_alpha = pipette.damping_alpha;
  system.damping_beta = pipette.damping_beta;
  system.loss_factor = pipette.loss_factor;
  system.loss_frequency = 2 * kPi * pipette.loss_frequency;
  system.immersion = immersion_of(pipette, section, layout, system.size());
  return system;
}

}  // namespace

BeamSystem assemble(const Section& section, const BeamLayout& layout) {
  BeamSystem system;
  elements().assemble(section, layout, system);
  return system;
}

std::vector<QuadraturePoint> quadrature_points(const Section& section, const BeamLayout& layout) {
  std::vector<QuadraturePoint> points;
  elements().quadrature_points(section, layout, points);
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
  check(pipette);
  Pipette rod = pipette;
  rod.fill_density *= pipette.axial_fill_share;
  for (FillColumn& column : rod.columns) column.density *= pipette.axial_fill_share;
  rod.bath = {};
  Section section = section_of(rod);
  section.axial_rigidity = [rod](double x) {
    return rod.youngs_modulus * glass_area(diameters_at(rod, x));
  };
  return system_of(rod, section,
                   {rod.elements, Supports::clamped_free, rod.length, Deformation::stretching});
}

BeamSystem simply_supported(const Pipette& pipette) {
  return system_of(pipette, section_of(pipette),
                   {pipette.elements, Supports::pinned_pinned, pipette.length / 2});
}

}  // namespace zona::beam
