#include "mpm/single_point.h"

#include <Eigen/Dense>
#include <algorithm>

#include "mpm/lattice.h"

namespace zona::mpm {

namespace {

using Eigen::Vector3d;

constexpr double any_density = 1000;

/// What the tensors of a body say about its first point.
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

/// `axes` are those of the surface's normal in the frame of the strain.
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

void strain_membrane(MaterialPoints& points, Membrane& membrane, const SymmetricTensor& strain) {
  for (int p = 0; p < points.size(); ++p) {
    const Vector3d x = points.position_of(p);
    points.next_position[0][p] = x.x() + strain[0] * x.x() + strain[3] * x.y();
    points.next_position[1][p] = x.y() + strain[3] * x.x() + strain[1] * x.y();
  }
  membrane.update_stress(points.next_position, 0, 1);
}

/// Residual and strain of the free components, as vectors.
class FreePart {
 public:
  FreePart(const SinglePoint& start, const SymmetricTensor& target, const FreeComponents& free)
      : start_(start), target_(target) {
    for (int c = 0; c < 6; ++c) {
      if (free[c]) components_.push_back(c);
    }
  }

  int size() const { return static_cast<int>(components_.size()); }
  SinglePoint moved(const Eigen::VectorXd& strains) const {
    SymmetricTensor strain = target_;
    for (int i = 0; i < size(); ++i) strain[components_[i]] = strains[i];
    SinglePoint point = start_;
    point.strain_to(strain);
    return point;
  }
  Eigen::VectorXd stress(const SinglePoint& point) const {
    const SymmetricTensor all = point.sample().stress;
    Eigen::VectorXd part(size());
    for (int i = 0; i < size(); ++i) part[i] = all[components_[i]];
    return part;
  }
  Eigen::VectorXd strains_at_start() const {
    const SymmetricTensor all = start_.sample().strain;
    Eigen::VectorXd part(size());
    for (int i = 0; i < size(); ++i) part[i] = all[components_[i]];
    return part;
  }
  Eigen::MatrixXd stiffness(const Eigen::VectorXd& strains, const Eigen::VectorXd& at) const {
    constexpr double difference = 1e-8;
    Eigen::MatrixXd k(size(), size());
    for (int i = 0; i < size(); ++i) {
      Eigen::VectorXd shifted = strains;
      shifted[i] += difference;
      k.col(i) = (stress(moved(shifted)) - at) / difference;
    }
    return k;
  }
  /// The least strains that change the stress by so much. What is hardly resisted, by wrinkles or
  /// what has failed, does not move.
  Eigen::VectorXd strains_for(const Eigen::MatrixXd& stiffness,
                              const Eigen::VectorXd& stress) const {
    const double least = 1e-9 * start_.youngs_modulus();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(stiffness,
                                                Eigen::ComputeThinU | Eigen::ComputeThinV);
    Eigen::VectorXd along = svd.matrixU().transpose() * stress;
    for (int i = 0; i < size(); ++i) {
      const double resistance = svd.singularValues()[i];
      along[i] = resistance > least ? along[i] / resistance : 0;
    }
    return svd.matrixV() * along;
  }
  void set_target(const SymmetricTensor& target) { target_ = target; }

 private:
  const SinglePoint& start_;
  SymmetricTensor target_;
  std::vector<int> components_;
};

/// Strains of the free components that the tangent at the start foretells for the whole step.
Eigen::VectorXd foretold(FreePart part, const SymmetricTensor& start,
                         const SymmetricTensor& target) {
  constexpr double fraction = 1e-4;
  SymmetricTensor little = start;
  for (int c = 0; c < 6; ++c) little[c] += fraction * (target[c] - start[c]);
  part.set_target(little);
  const Eigen::VectorXd strains = part.strains_at_start();
  const Eigen::VectorXd stress = part.stress(part.moved(strains));
  const Eigen::MatrixXd k = part.stiffness(strains, stress);
  return strains - part.strains_for(k, stress) / fraction;
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
  const ElasticProperties properties{any_density, moduli.youngs_modulus, moduli.poisson_ratio};
  return std::visit(
      [&](const auto& l) -> Point { return Solid<std::decay_t<decltype(l)>>(properties, 1, l); },
      law);
}

SinglePoint::Point SinglePoint::sheet_point(const MembraneProperties& properties,
                                            const MembraneLaw& law) {
  const auto surface = sheet(Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY(), 2, 2);
  const auto points =
      make_points(surface.places, std::vector<double>(surface.places.size(), any_density));
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

double step_to(SinglePoint& point, const SymmetricTensor& target, const FreeComponents& free) {
  const SinglePoint start = point;
  const FreePart part(start, target, free);
  if (part.size() == 0) return point.strain_to(target), 0.0;
  Eigen::VectorXd strains = foretold(part, start.sample().strain, target);
  Eigen::VectorXd correction = Eigen::VectorXd::Zero(part.size());
  double least = HUGE_VAL;
  constexpr int most = 60;
  for (int i = 0; i < most && least > 0; ++i) {
    const SinglePoint tried = part.moved(strains - correction);
    const Eigen::VectorXd stress = part.stress(tried);
    const double left = stress.cwiseAbs().maxCoeff();
    if (left >= least) {
      correction *= 0.5;  // the stress is not smooth: where it yields, wrinkles or opens
      continue;
    }
    least = left;
    point = tried;
    strains -= correction;
    correction = part.strains_for(part.stiffness(strains, stress), stress);
  }
  return least;
}

}  // namespace zona::mpm
