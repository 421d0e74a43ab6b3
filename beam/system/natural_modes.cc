#include "beam/system/natural_modes.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

namespace zona::beam {

Eigen::VectorXd NaturalModes::frequency() const {
  return angular_frequency / (2 * M_PI);
}

NaturalModes natural_modes(const BeamSystem& system) {
  // Scale to a unit diagonal of the mass, so that all entries of a matrix have the same unit and
  // magnitude: the lowest frequency of a fine mesh keeps more digits.
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(system.size());
  const Eigen::MatrixXd raw_mass = system.mass.dense();
  for (int i = 0; i < system.size(); ++i) scale(i) = 1 / std::sqrt(raw_mass(i, i));
  const auto scaling = scale.asDiagonal();
  const Eigen::MatrixXd mass = scaling * raw_mass * scaling;
  const Eigen::MatrixXd stiffness = scaling * system.stiffness.dense() * scaling;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("natural modes: the eigenvalue iteration did not converge");

  NaturalModes modes;
  modes.angular_frequency = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  modes.shape = scaling * solver.eigenvectors();
  modes.participation = modes.shape.transpose() * system.support_mass;
  modes.observed = modes.shape.transpose() * system.observation;
  return modes;
}

}  // namespace zona::beam
