#pragma once

#include <Eigen/Core>
#include <vector>

#include "beam/motion/support_motion.h"
#include "beam/system/beam_system.h"

namespace zona::beam {

/// Range of angular frequencies for the Maxwell elements of a transient beam.
struct FrequencySpan {
  double lowest = 0;   ///< [rad/s]
  double highest = 0;  ///< [rad/s]
};

/// A beam in the form for time integration. Maxwell elements represent its viscous loads and its
/// loss factor, with memory variables y_j:
///
///     M q'' + C q' + K q + sum_k B_k sum_j w_jk y_j = -m g'' - c g' - sum_k b_k sum_j w_jk z_j,
///     y_j' = q' - p_j y_j,      z_j' = g' - p_j z_j.
///
/// Without liquids and a loss factor these are the equations of BeamSystem. BathModel::constant
/// changes M and C only.
struct TransientBeam {
  SymmetricBand mass;                    ///< M
  SymmetricBand damping;                 ///< C, of structure and liquids
  SymmetricBand stiffness;               ///< K
  Eigen::VectorXd support_mass;          ///< m
  Eigen::VectorXd support_damping;       ///< c
  bool is_damped = false;                ///< true if C is not zero
  Eigen::ArrayXd rate;                   ///< p_j [1/s]
  std::vector<SymmetricBand> basis;      ///< B_k
  std::vector<Eigen::VectorXd> support;  ///< b_k
  Eigen::MatrixXd weight;                ///< w_jk, a row per rate
  std::vector<QuadraturePoint> drag;     ///< as in LiquidLoads

  int size() const { return mass.size(); }                        ///< degrees of freedom
  int memories() const { return static_cast<int>(rate.size()); }  ///< number of y_j
};

/// The beam in this form. Throws std::invalid_argument for BathModel::per_mode, which has none.
TransientBeam transient_beam(const BeamSystem& system, const FrequencySpan& span);

/// Quadratic drag f = D(v) v + d(v) g', where D = sum |V| weight N N^T with the absolute velocity
/// V = N . v + r g' at each point.
class QuadraticDrag {
 public:
  /// Keeps a reference to the beam.
  explicit QuadraticDrag(const TransientBeam& beam) : points_(&beam.drag), matrix_(beam.size()) {}

  bool acts() const { return !points_->empty(); }  ///< true if the beam has quadratic drag
  /// Computes D and d at these relative velocities and this velocity of the support [m/s].
  void linearise(const Eigen::VectorXd& velocity, double support_velocity);
  /// force += D v + d g' [N], [N m].
  void add_force(const Eigen::VectorXd& velocity, double support_velocity,
                 Eigen::VectorXd& force) const;
  const SymmetricBand& matrix() const { return matrix_; }  ///< D

 private:
  double velocity_at(const QuadraturePoint& point, const Eigen::VectorXd& velocity,
                     double support_velocity) const;

  const std::vector<QuadraturePoint>* points_;
  std::vector<double> coefficient_;
  SymmetricBand matrix_;
};

/// Velocity g' of a support while `march` advances: it jumps at kinks and, for a sine, varies
/// between them.
class SupportVelocity {
 public:
  /// Starts at rest before t = 0. Keeps a reference to the motion.
  explicit SupportVelocity(const SupportMotion& motion) : motion_(&motion) {}

  double now() const { return value_; }       ///< [m/s]
  void kick(double jump) { value_ += jump; }  ///< applies the jump [m/s] of a kink
  void advance(double to);                    ///< goes to the end [s] of a span without kinks

  /// Velocity [m/s] at a time [s] in the span after the last advance or kick.
  double at(double time) const;

 private:
  const SupportMotion* motion_;
  double value_ = 0;
};

}  // namespace zona::beam
