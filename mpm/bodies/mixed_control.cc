#include "mpm/bodies/mixed_control.h"

#include <Eigen/SVD>

namespace zona::mpm {

namespace {

/// Stress and strain of the free components, as vectors.
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
  /// Minimum-norm strains that change the stress by `stress`. Directions with almost no stiffness,
  /// such as wrinkles or failed points, are left alone.
  Eigen::VectorXd strains_for(const Eigen::MatrixXd& stiffness,
                              const Eigen::VectorXd& stress) const {
    const double least = 1e-9 * start_.youngs_modulus();
    const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(
        stiffness, Eigen::ComputeThinU | Eigen::ComputeThinV);
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

/// Strains of the free components for the whole step, predicted from the tangent at its start.
Eigen::VectorXd predicted_strains(FreePart part, const SymmetricTensor& start,
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

/// Takes the whole step at once; returns the residual as step_to does.
double try_step(SinglePoint& point, const SymmetricTensor& target, const FreeComponents& free) {
  const SinglePoint start = point;
  const FreePart part(start, target, free);
  if (part.size() == 0) return point.strain_to(target), 0.0;
  Eigen::VectorXd strains = predicted_strains(part, start.sample().strain, target);
  Eigen::VectorXd correction = Eigen::VectorXd::Zero(part.size());
  double least = HUGE_VAL;
  constexpr int max_iterations = 60;
  for (int i = 0; i < max_iterations && least > 0; ++i) {
    const SinglePoint tried = part.moved(strains - correction);
    const Eigen::VectorXd stress = part.stress(tried);
    const double left = stress.cwiseAbs().maxCoeff();
    if (left >= least) {
      correction *= 0.5;  // the stress is not smooth where the point yields, wrinkles or opens
      continue;
    }
    least = left;
    point = tried;
    strains -= correction;
    correction = part.strains_for(part.stiffness(strains, stress), stress);
  }
  return least;
}

double step_in_parts(SinglePoint& point, const SymmetricTensor& target, const FreeComponents& free,
                     int halvings) {
  const SinglePoint start = point;
  const double left = try_step(point, target, free);
  if (left <= 1e-9 * point.youngs_modulus() || halvings == 0) return left;
  point = start;
  const SymmetricTensor from = start.sample().strain;
  SymmetricTensor middle;
  for (int c = 0; c < 6; ++c) middle[c] = 0.5 * (from[c] + target[c]);
  step_in_parts(point, middle, free, halvings - 1);
  return step_in_parts(point, target, free, halvings - 1);
}

}  // namespace

double step_to(SinglePoint& point, const SymmetricTensor& target, const FreeComponents& free) {
  constexpr int max_halvings = 6;
  return step_in_parts(point, target, free, max_halvings);
}

}  // namespace zona::mpm
