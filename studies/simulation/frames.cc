#include "studies/simulation/frames.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "mpm/results/cell_averages.h"
#include "studies/measures/point_values.h"

namespace zona::studies {

namespace {

/// value(p) of each point p, in the order of ids.
template <class F>
std::vector<double> by_id(const mpm::Body& body, F value) {
  std::vector<double> ordered(body.points.id.size());
  for (int p = 0; p < body.points.size(); ++p) ordered[body.points.id[p]] = value(p);
  return ordered;
}

std::vector<double> vectors_by_id(const mpm::Body& body, const std::array<mpm::Field, 3>& field) {
  std::vector<double> ordered(3 * body.points.id.size());
  for (int p = 0; p < body.points.size(); ++p) {
    for (int axis = 0; axis < 3; ++axis) ordered[3 * body.points.id[p] + axis] = field[axis][p];
  }
  return ordered;
}

std::vector<double> scalar(const mpm::Body& body, const std::string& quantity) {
  const std::size_t place = point_quantity(quantity).first;
  const Eigen::Vector3d start = Eigen::Vector3d::Zero();  // only displacements need it
  return by_id(body, [&](int p) { return values_at(body, p, start).value[place]; });
}

/// Largest principal stress at a membrane's point times the thickness [N/m].
double tension(const mpm::Membrane& membrane, int p) {
  const auto& s = membrane.stress;
  Eigen::Matrix3d stress;
  stress << s[0][p], s[3][p], s[5][p], s[3][p], s[1][p], s[4][p], s[5][p], s[4][p], s[2][p];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(stress, Eigen::EigenvaluesOnly);
  return principal.eigenvalues()[2] * membrane.properties.thickness;
}

mpm::PointCloud point_cloud(const mpm::Body& body) {
  mpm::PointCloud cloud{body.name, vectors_by_id(body, body.points.position), {}, {}};
  if (const mpm::Membrane* membrane = body.membrane()) {
    cloud.triangles = membrane->surface.triangles();
    cloud.fields["failed"] = by_id(body, [&](int p) { return membrane->failed(p) ? 1.0 : 0.0; });
    cloud.fields["strain"] = by_id(body, [&](int p) { return membrane->strain[p]; });
    cloud.fields["damage"] = by_id(body, [&](int p) { return 1 - membrane->integrity.left[p]; });
    cloud.fields["tension"] = by_id(body, [&](int p) { return tension(*membrane, p); });
  }
  const bool fluid = std::holds_alternative<mpm::Fluid>(body.material);
  const bool solid = !fluid && !body.membrane() && !body.prescribed();
  if (fluid || solid) cloud.fields["pressure"] = scalar(body, "pressure");
  if (solid) {
    for (const char* name : {"equivalent_stress", "plastic_strain", "damage"}) {
      cloud.fields[name] = scalar(body, name);
    }
  }
  if (!body.prescribed()) cloud.fields["velocity"] = vectors_by_id(body, body.points.velocity);
  return cloud;
}

bool has_body(const mpm::Solver& solver, const std::string& name) {
  return std::any_of(solver.bodies().begin(), solver.bodies().end(),
                     [&](const mpm::Body& body) { return body.name == name; });
}

}  // namespace

std::vector<mpm::PointCloud> point_clouds(const mpm::Solver& solver) {
  std::vector<mpm::PointCloud> clouds;
  for (const auto& body : solver.bodies()) clouds.push_back(point_cloud(body));
  return clouds;
}

std::vector<mpm::CellFields> cell_fields(const mpm::Solver& solver) {
  std::vector<mpm::CellFields> cells;
  for (const auto& body : solver.bodies()) {
    if (!std::holds_alternative<mpm::Fluid>(body.material)) continue;
    std::string name = body.name + "_cells";
    while (has_body(solver, name)) name += "_";
    cells.push_back(mpm::cell_averages(body, solver.grid(), name));
  }
  return cells;
}

}  // namespace zona::studies
