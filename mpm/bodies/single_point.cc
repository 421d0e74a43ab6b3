#include "mpm/bodies/single_point.h"

#include "mpm/bodies/lattice.h"

namespace zona::mpm {

namespace {

using Eigen::Vector3d;

constexpr double arbitrary_density = 1000;

/// Components at the first point of a body.
SymmetricTensor first_of(const SymmetricTensorField& field) {
  SymmetricTensor values;
  for (int c = 0; c < 6; ++c) values[c] = field[c][0];
  return values;
}

double elastic_energy(const SymmetricTensor& s, const ElasticModuli& e) {
  const double trace = s[0] + s[1] + s[2];
  return ((1 + e.poisson_ratio) * contract(s, s) - e.poisson_ratio * trace * trace) /
         (2 * e.youngs_modulus);
}

/// `axes` are the axes of the surface's normal, in the frame of the strain.
template <int Dimensions>
void read_surface(const DecohesionFields<Dimensions>& surfaces,
                  const std::optional<Decohesion>& law,
                  const Eigen::Matrix<double, 3, Dimensions>& axes, PointSample& sample) {
  if (!law || !surfaces.surface(0).present()) return;
  Eigen::Matrix<double, Dimensions, 1> normal;
  for (int i = 0; i < Dimensions; ++i) normal[i] = surfaces.normal[i][0];
  sample.normal = axes * normal;
  sample.surface = surfaces.surface(0);
  sample.left = 1 - surfaces.opened[0];
  sample.opening_dissipation = surfaces.dissipated[0];
  sample.resolved_energy = sample.surface.energy(*law);
  sample.effective_length = effective_length(sample.normal, law->cell);
}

void read_state(const Solid<Elastic>& solid, PointSample& sample) {
  sample.stored_energy = elastic_energy(sample.stress, solid.properties.moduli());
}

void read_state(const Solid<VonMises>& solid, PointSample& sample) {
  sample.stored_energy = elastic_energy(sample.stress, solid.properties.moduli());
  sample.internal = solid.state.internal[0];
  sample.flow_dissipation = solid.state.dissipated[0];
  read_surface<3>(solid.state.surfaces, solid.law.decohesion, Eigen::Matrix3d::Identity(), sample);
}

void read_state(const Solid<Elastodamage>& solid, PointSample& sample) {
  sample.left = solid.state.integrity[0];
  sample.stored_energy = sample.left * elastic_energy(first_of(solid.state.effective_stress),
                                                      solid.properties.moduli());
}

void read_state(const Membrane& membrane, PointSample& sample) {
  sample.stored_energy = membrane.energy_density[0];
  sample.left = membrane.integrity.left[0];
  const auto* plastic = std::get_if<MembraneState<VonMises>>(&membrane.state);
  if (!plastic) return;
  sample.internal = plastic->internal[0];
  sample.flow_dissipation = plastic->dissipated[0];
  const auto frame = std::visit([](const auto& k) { return k.local_strain(consecutive(0, 4)); },
                                membrane.kinematics);
  Eigen::Matrix<double, 3, 2> axes;
  for (int i = 0; i < 3; ++i) axes.row(i) << frame.x[i][0], frame.y[i][0];
  read_surface<2>(plastic->surfaces, plastic->law.decohesion, axes, sample);
}

template <class Law>
void strain_solid(Solid<Law>& solid, const SymmetricTensor& increment) {
  constexpr int row[6] = {0, 1, 2, 0, 1, 2};
  constexpr int column[6] = {0, 1, 2, 1, 2, 0};
  VelocityGradient gradient{};
  for (int c = 0; c < 6; ++c) {
    gradient[row[c]][column[c]] = gradient[column[c]][row[c]] = broadcast(increment[c]);
  }
  const int point = 0;
  solid.update(PointGroup(&point, 1), gradient, 1, 1);
}

void strain_membrane(const MaterialPoints& points, Membrane& membrane,
                     const SymmetricTensor& strain) {
  std::array<Field, 3> strained = points.position;
  for (int p = 0; p < points.size(); ++p) {
    const Vector3d x = points.position_of(p);
    strained[0][p] = x.x() + strain[0] * x.x() + strain[3] * x.y();
    strained[1][p] = x.y() + strain[3] * x.x() + strain[1] * x.y();
  }
  membrane.update_stress(strained, 0, 1);
}

}  // namespace

double contract(const SymmetricTensor& a, const SymmetricTensor& b) {
  double sum = 0;
  for (int c = 0; c < 6; ++c) sum += (c < 3 ? 1 : 2) * a[c] * b[c];
  return sum;
}

double equivalent_stress(const SymmetricTensor& stress) {
  SymmetricTensor deviator = stress;
  for (int c = 0; c < 3; ++c) deviator[c] -= (stress[0] + stress[1] + stress[2]) / 3;
  return std::sqrt(1.5 * contract(deviator, deviator));
}

SinglePoint::SinglePoint(const ElasticModuli& moduli, const SolidLaw& law)
    : point_(solid_point(moduli, law)) {}

SinglePoint::SinglePoint(const MembraneProperties& properties, const MembraneLaw& law)
    : point_(sheet_point(properties, law)) {}

SinglePoint::Point SinglePoint::solid_point(const ElasticModuli& moduli, const SolidLaw& law) {
  const ElasticProperties properties{arbitrary_density, moduli.youngs_modulus,
                                     moduli.poisson_ratio};
  return std::visit(
      [&](const auto& l) -> Point { return Solid<std::decay_t<decltype(l)>>(properties, 1, l); },
      law);
}

SinglePoint::Point SinglePoint::sheet_point(const MembraneProperties& properties,
                                            const MembraneLaw& law) {
  const auto surface = sheet(Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY(), 2, 2);
  const auto points =
      make_points(surface.places, std::vector<double>(surface.places.size(), arbitrary_density));
  return Sheet{points, Membrane(properties, law, true, points, surface.triangles)};
}

void SinglePoint::strain_to(const SymmetricTensor& strain) {
  SymmetricTensor increment;
  for (int c = 0; c < 6; ++c) increment[c] = strain[c] - strain_[c];
  strain_ = strain;
  std::visit(
      [&](auto& point) {
        if constexpr (std::is_same_v<std::decay_t<decltype(point)>, Sheet>) {
          strain_membrane(point.points, point.membrane, strain);
        } else {
          strain_solid(point, increment);
        }
      },
      point_);
}

PointSample SinglePoint::sample() const {
  PointSample sample;
  sample.strain = strain_;
  std::visit(
      [&](const auto& point) {
        if constexpr (std::is_same_v<std::decay_t<decltype(point)>, Sheet>) {
          sample.stress = first_of(point.membrane.stress);
          read_state(point.membrane, sample);
        } else {
          sample.stress = first_of(point.stress);
          read_state(point, sample);
        }
      },
      point_);
  return sample;
}

double SinglePoint::youngs_modulus() const {
  return std::visit(
      [](const auto& point) {
        if constexpr (std::is_same_v<std::decay_t<decltype(point)>, Sheet>) {
          return point.membrane.properties.youngs_modulus;
        } else {
          return point.properties.youngs_modulus;
        }
      },
      point_);
}

}  // namespace zona::mpm
