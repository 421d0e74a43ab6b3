#include "beam/system/elements_library.h"

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/full_matrix.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "beam/algebra/require.h"

namespace zona::beam {
namespace {

using dealii::FullMatrix;
constexpr int element_dofs = QuadraturePoint::dofs;
constexpr int gauss_points = 5;

/// Shape functions and their strains at a point of an element: curvatures of Hermite cubics
/// (deflection and rotation at the left vertex, then at the right one), or slopes of Lagrange
/// cubics, node by node.
struct ShapeValues {
  std::array<double, element_dofs> value;
  std::array<double, element_dofs> strain;
};

ShapeValues hermite_shapes(double xi, double element_length) {
  // deal.II orders value left, value right, slope left, slope right, on the unit interval.
  constexpr std::array<unsigned int, element_dofs> order = {0, 2, 1, 3};
  static const auto basis = dealii::Polynomials::HermiteInterpolation::generate_complete_basis(3);
  ShapeValues shapes{};
  for (int i = 0; i < element_dofs; ++i) {
    std::array<double, 3> derivatives{};
    basis[order[i]].value(xi, 2, derivatives.data());
    const double scale = i % 2 == 1 ? element_length : 1;
    shapes.value[i] = scale * derivatives[0];
    shapes.strain[i] = scale * derivatives[2] / (element_length * element_length);
  }
  return shapes;
}

ShapeValues lagrange_shapes(double xi, double element_length) {
  static const auto basis = dealii::Polynomials::generate_complete_Lagrange_basis(
      dealii::QGaussLobatto<1>(element_dofs).get_points());
  ShapeValues shapes{};
  for (int i = 0; i < element_dofs; ++i) {
    std::array<double, 2> derivatives{};
    basis[i].value(xi, 1, derivatives.data());
    shapes.value[i] = derivatives[0];
    shapes.strain[i] = derivatives[1] / element_length;
  }
  return shapes;
}

ShapeValues shapes_at(Deformation deformation, double xi, double element_length) {
  return deformation == Deformation::bending ? hermite_shapes(xi, element_length)
                                             : lagrange_shapes(xi, element_length);
}

struct ElementMatrices {
  FullMatrix<double> mass{element_dofs, element_dofs};
  FullMatrix<double> stiffness{element_dofs, element_dofs};
};

ElementMatrices element_matrices(const Section& section, Deformation deformation, double left,
                                 double element_length) {
  const bool bends = deformation == Deformation::bending;
  const dealii::QGauss<1> quadrature(gauss_points);
  ElementMatrices element;
  for (unsigned int point = 0; point < quadrature.size(); ++point) {
    const double xi = quadrature.point(point)[0];
    const double x = left + xi * element_length;
    const double weight = quadrature.weight(point) * element_length;
    const double rigidity = bends ? section.flexural_rigidity(x) : section.axial_rigidity(x);
    const double mass = section.mass_per_length(x);
    require(is_positive(rigidity) && is_positive(mass),
            fmt::format("beam: at x = {} m the {} and the mass {} kg/m, but both must be greater "
                        "than 0; correct the section there",
                        x,
                        bends ? fmt::format("flexural rigidity is {} N m^2", rigidity)
                              : fmt::format("axial rigidity is {} N", rigidity),
                        mass));
    const ShapeValues shapes = shapes_at(deformation, xi, element_length);
    for (int i = 0; i < element_dofs; ++i)
      for (int j = 0; j < element_dofs; ++j) {
        element.mass(i, j) += weight * mass * shapes.value[i] * shapes.value[j];
        element.stiffness(i, j) += weight * rigidity * shapes.strain[i] * shapes.strain[j];
      }
  }
  return element;
}

/// Number of degrees of freedom from one vertex to the next.
int stride(Deformation deformation) {
  return deformation == Deformation::bending ? 2 : element_dofs - 1;
}

/// Index of every degree of freedom (deflection and rotation per vertex, or axial displacement per
/// node) among the free ones.
std::vector<int> number_free_dofs(const BeamLayout& layout, unsigned int elements) {
  const bool bends = layout.deformation == Deformation::bending;
  const int dofs = stride(layout.deformation) * static_cast<int>(elements) + (bends ? 2 : 1);
  std::vector<bool> essential(dofs, false);
  essential[0] = true;
  if (bends) essential[layout.supports == Supports::clamped_free ? 1 : dofs - 2] = true;
  std::vector<int> number(dofs, QuadraturePoint::held);
  int next = 0;
  for (int dof = 0; dof < dofs; ++dof)
    if (!essential[dof]) number[dof] = next++;
  return number;
}

/// Rigid motion r(x) for unit displacement of the support.
double rigid_deflection(Supports supports, double x, double length) {
  return supports == Supports::clamped_free ? 1 : 1 - x / length;
}

double rigid_slope(Supports supports, double length) {
  return supports == Supports::clamped_free ? 0 : -1 / length;
}

void check_layout(const Section& section, const BeamLayout& layout) {
  require(is_positive(section.length),
          fmt::format("beam: length is {} m, but it must be greater than 0", section.length));
  const int fewest = layout.supports == Supports::clamped_free ? 1 : 2;
  require(layout.elements >= fewest,
          fmt::format("beam: {} elements, but at least {} are needed; use 20 or more",
                      layout.elements, fewest));
  require(layout.deformation == Deformation::bending || layout.supports == Supports::clamped_free,
          "beam: a rod is held at one end and free at the other; use Supports::clamped_free");
  require(layout.deformation == Deformation::bending || section.axial_rigidity,
          "beam: the section of a rod has no axial rigidity; give Section::axial_rigidity");
  require(layout.observed_at >= 0 && layout.observed_at <= section.length,
          fmt::format("beam: the observed point x = {} m lies outside the beam, 0 to {} m",
                      layout.observed_at, section.length));
}

/// One element: its ends [m] and the indices of its degrees of freedom.
struct Element {
  double left;
  double right;
  std::array<int, element_dofs> dof;

  double length() const { return right - left; }
};

/// Ends of about `elements` elements [m], evenly spaced between the breaks of the section.
std::vector<double> element_ends(const Section& section, int elements) {
  const double length = section.length;
  const double nearest = 1e-6 * length;
  std::vector<double> breaks = section.breaks;
  std::sort(breaks.begin(), breaks.end());
  breaks.push_back(length);
  std::vector<double> ends = {0};
  for (const double to : breaks) {
    const double from = ends.back();
    const bool is_tip = to == length;
    if (!is_tip && (to < from + nearest || to > length - nearest)) continue;
    const int count = std::max(1, static_cast<int>(std::lround(elements * (to - from) / length)));
    for (int i = 1; i <= count; ++i)
      ends.push_back(i == count ? to : from + i * ((to - from) / count));
    if (is_tip) break;
  }
  return ends;
}

/// Makes the mesh with deal.II.
void make_mesh(const Section& section, const BeamLayout& layout, dealii::Triangulation<1>& mesh) {
  if (section.breaks.empty()) {
    dealii::GridGenerator::subdivided_hyper_cube(mesh, layout.elements, 0., section.length);
    return;
  }
  const std::vector<double> ends = element_ends(section, layout.elements);
  std::vector<std::vector<double>> steps(1);
  for (std::size_t i = 1; i < ends.size(); ++i) steps[0].push_back(ends[i] - ends[i - 1]);
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, steps, dealii::Point<1>(0.),
                                                    dealii::Point<1>(section.length));
}

BeamSystem empty_system(const Section& section, const BeamLayout& layout,
                        const std::vector<int>& number) {
  const bool bends = layout.deformation == Deformation::bending;
  const int size = *std::max_element(number.begin(), number.end()) + 1;
  BeamSystem system;
  system.mass = SymmetricBand(size);
  system.stiffness = SymmetricBand(size);
  system.support_mass = Eigen::VectorXd::Zero(size);
  system.observation = Eigen::VectorXd::Zero(size);
  system.support_share = rigid_deflection(layout.supports, layout.observed_at, section.length);
  system.element_length = section.length / layout.elements;
  for (std::size_t dof = 0; dof < number.size(); ++dof)
    if (number[dof] != QuadraturePoint::held) system.rotation.push_back(bends && dof % 2 == 1);
  return system;
}

void add_element(const Section& section, const BeamLayout& layout, const Element& element,
                 BeamSystem& system) {
  const ElementMatrices matrices =
      element_matrices(section, layout.deformation, element.left, element.length());
  const double slope = rigid_slope(layout.supports, section.length);
  std::array<double, element_dofs> rigid = {
      rigid_deflection(layout.supports, element.left, section.length), slope,
      rigid_deflection(layout.supports, element.right, section.length), slope};
  if (layout.deformation == Deformation::stretching) rigid.fill(1);
  for (int i = 0; i < element_dofs; ++i) {
    const int row = element.dof[i];
    if (row == QuadraturePoint::held) continue;
    for (int j = 0; j < element_dofs; ++j) {
      system.support_mass(row) += matrices.mass(i, j) * rigid[j];
      const int column = element.dof[j];
      if (column == QuadraturePoint::held || column > row) continue;
      system.mass.add(row, column, matrices.mass(i, j));
      system.stiffness.add(row, column, matrices.stiffness(i, j));
    }
  }
}

void observe(const Element& element, const BeamLayout& layout, BeamSystem& system) {
  const double xi = (layout.observed_at - element.left) / element.length();
  const ShapeValues shapes = shapes_at(layout.deformation, xi, element.length());
  for (int i = 0; i < element_dofs; ++i)
    if (element.dof[i] != QuadraturePoint::held)
      system.observation(element.dof[i]) = shapes.value[i];
}

/// The elements from x = 0 to the tip.
std::vector<Element> make_elements(const dealii::Triangulation<1>& mesh, Deformation deformation,
                                   const std::vector<int>& number) {
  std::vector<Element> elements;
  for (const auto& cell : mesh.active_cell_iterators()) {
    Element element{cell->vertex(0)[0], cell->vertex(1)[0], {}};
    for (int i = 0; i < element_dofs; ++i)
      element.dof[i] = number[stride(deformation) * cell->vertex_index(0) + i];
    elements.push_back(element);
  }
  return elements;
}

BeamSystem assemble_with_deal_ii(const Section& section, const BeamLayout& layout) {
  check_layout(section, layout);
  dealii::Triangulation<1> mesh;
  make_mesh(section, layout, mesh);
  const std::vector<int> number = number_free_dofs(layout, mesh.n_active_cells());
  BeamSystem system = empty_system(section, layout, number);
  const std::vector<Element> elements = make_elements(mesh, layout.deformation, number);
  for (const Element& element : elements) {
    add_element(section, layout, element, system);
    const bool is_last = &element == &elements.back();
    if (layout.observed_at >= element.left && (layout.observed_at < element.right || is_last))
      observe(element, layout, system);
  }
  return system;
}

std::vector<QuadraturePoint> quadrature_points_with_deal_ii(const Section& section,
                                                            const BeamLayout& layout) {
  check_layout(section, layout);
  dealii::Triangulation<1> mesh;
  make_mesh(section, layout, mesh);
  const dealii::QGauss<1> quadrature(gauss_points);
  const std::vector<int> number = number_free_dofs(layout, mesh.n_active_cells());
  std::vector<QuadraturePoint> points;
  for (const Element& element : make_elements(mesh, layout.deformation, number))
    for (unsigned int q = 0; q < quadrature.size(); ++q) {
      const double xi = quadrature.point(q)[0];
      const double x = element.left + xi * element.length();
      points.push_back({x, quadrature.weight(q) * element.length(), element.dof,
                        shapes_at(layout.deformation, xi, element.length()).value,
                        rigid_deflection(layout.supports, x, section.length)});
    }
  return points;
}

}  // namespace
}  // namespace zona::beam

void zona_beam_assemble(const zona::beam::Section& section, const zona::beam::BeamLayout& layout,
                        zona::beam::BeamSystem& system) {
  system = zona::beam::assemble_with_deal_ii(section, layout);
}

void zona_beam_quadrature_points(const zona::beam::Section& section,
                                 const zona::beam::BeamLayout& layout,
                                 std::vector<zona::beam::QuadraturePoint>& points) {
  points = zona::beam::quadrature_points_with_deal_ii(section, layout);
}
