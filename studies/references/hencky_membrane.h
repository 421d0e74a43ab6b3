#pragma once

#include <vector>

namespace zona::studies::references {

/// A flat, unstressed circular membrane, clamped along its edge, under a pressure on one side.
struct PressurisedDisc {
  double radius;          ///< a [m]
  double thickness;       ///< h [m]
  double youngs_modulus;  ///< E [Pa]
  double poisson_ratio;   ///< nu [-]
  double pressure;        ///< q [Pa]

  /// q a/(E h); the theory needs its cube root to be small.
  double load() const { return pressure * radius / (youngs_modulus * thickness); }
};

/// Hencky's solution (Z. Math. Phys. 63, 311, 1915): moderate rotations, small strains, the load
/// along the axis. With X = (r/a)^2 and k = q a/(E h),
///   N_r = E h k^(2/3) B(X)/4,  N_t = d(r N_r)/dr,  dw/dr = -2 k^(1/3) (r/a)/B,
/// where equilibrium is satisfied and compatibility, D(2 + D) B = -8 X/B^2 with D = 2X d/dX, gives
/// the series B = sum b_n X^n, b_n = -2 [1/B^2]_{n-1}/(n (n + 1)). The edge does not move:
/// sum b_n (1 - nu + 2n) = 0 determines b_0. Deflection in the middle: w_0 = 0.653 a k^(1/3) for
/// nu = 0.3 (Hencky's 0.662 is a slip).
class HenckyMembrane {
 public:
  /// Throws ModelError unless 0 <= nu <= 0.5 and everything else is positive.
  explicit HenckyMembrane(const PressurisedDisc& disc);

  double first_coefficient() const { return b_[0]; }  ///< b_0; 1.7244 for nu = 0.3
  double deflection(double r) const;                  ///< w [m]
  double slope(double r) const;                       ///< dw/dr
  double radial_tension(double r) const;              ///< N_r [N/m]
  double hoop_tension(double r) const;                ///< N_t [N/m]

 private:
  double series(double x) const;
  PressurisedDisc disc_;
  std::vector<double> b_;           ///< of B
  std::vector<double> reciprocal_;  ///< of 1/B, whose integral is the deflection
};

}  // namespace zona::studies::references
