#pragma once

#include <Eigen/Core>

#include "beam/system/beam_system.h"

namespace zona::beam {

/// Undamped modes K phi = omega^2 M phi of a beam by increasing frequency, with phi^T M phi = 1.
struct NaturalModes {
  Eigen::VectorXd angular_frequency;  ///< omega [rad/s]
  Eigen::MatrixXd shape;              ///< one mode per column, free degrees of freedom per row
  Eigen::VectorXd participation;      ///< phi^T m: modal force per -g''
  Eigen::VectorXd observed;           ///< phi at the observed point

  Eigen::VectorXd frequency() const;  ///< f = omega / (2 pi) [Hz]
};

/// All modes of a beam, one per degree of freedom. Throws std::runtime_error if the eigenvalue
/// solver does not converge.
NaturalModes natural_modes(const BeamSystem& system);

}  // namespace zona::beam
