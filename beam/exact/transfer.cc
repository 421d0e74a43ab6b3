#include "beam/exact/transfer.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>

namespace zona::beam {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::Matrix<Complex, 4, 4>;

/// Forces on the ends of a piece (shear force and moment at the left, then at the right) for unit
/// deflections and rotations of the ends. The basis exp(-kx), exp(-k(l - x)), exp(ikx), exp(-ikx),
/// with the last two scaled to their greater end, never exceeds 1.
Matrix dynamic_stiffness(const UniformPiece& piece, const Liquid& liquid, Complex s) {
  Complex inertia = piece.mass_per_length * s * s;
  if (piece.radius > 0)
    inertia += liquid.density * M_PI * piece.radius * piece.radius * s * s +
               s * viscous_load(Flow::across, liquid, piece.radius, s);
  Complex k = std::sqrt(std::sqrt(-inertia / piece.flexural_rigidity));
  if (k.real() < 0) k = -k;
  const Complex i(0, 1);
  const double l = piece.length;
  // exp(root x) decays from the end at which it is 1.
  const std::array<Complex, 4> root{-k, k, k.imag() > 0 ? i * k : -i * k,
                                    k.imag() > 0 ? -i * k : i * k};
  Matrix ends, forces;
  for (int n = 0; n < 4; ++n) {
    const Complex r = root[n];
    const bool from_left = n % 2 == 0;
    const Complex left = from_left ? 1 : std::exp(-r * l);
    const Complex right = from_left ? std::exp(r * l) : 1;
    ends.col(n) << left, r * left, right, r * right;
    const Complex rigidity = piece.flexural_rigidity;
    forces.col(n) << rigidity * r * r * r * left, -rigidity * r * r * left,
        -rigidity * r * r * r * right, rigidity * r * r * right;
  }
  return forces * ends.inverse();
}

}  // namespace

Complex exact_transfer(const std::vector<UniformPiece>& pieces, const Liquid& liquid, Complex s) {
  const auto count = static_cast<Eigen::Index>(pieces.size());
  Eigen::MatrixXcd stiffness = Eigen::MatrixXcd::Zero(2 * count + 2, 2 * count + 2);
  for (Eigen::Index p = 0; p < count; ++p)
    stiffness.block<4, 4>(2 * p, 2 * p) += dynamic_stiffness(pieces[p], liquid, s);
  const Eigen::VectorXcd free_ends = stiffness.bottomRightCorner(2 * count, 2 * count)
                                         .partialPivLu()
                                         .solve(-stiffness.block(2, 0, 2 * count, 1));
  return free_ends(2 * count - 2);
}

Complex exact_rod_transfer(const std::vector<UniformRodPiece>& pieces, const Liquid& liquid,
                           Complex s) {
  // u and EA u', from the tip, where they are 1 and 0, to the support.
  Complex motion = 1, force = 0;
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
    Complex inertia = piece->mass_per_length * s * s;
    if (piece->outer_radius > 0)
      inertia += s * viscous_load(Flow::along, liquid, piece->outer_radius, s);
    if (piece->fill.density > 0)
      inertia += s * viscous_load(Flow::within, piece->fill, piece->inner_radius, s);
    const Complex k = std::sqrt(inertia / piece->axial_rigidity);
    const Complex cosine = std::cosh(k * piece->length), sine = std::sinh(k * piece->length);
    const Complex stiffness = piece->axial_rigidity * k;
    const Complex before = motion;
    motion = cosine * before - sine / stiffness * force;
    force = cosine * force - stiffness * sine * before;
  }
  return 1. / motion;
}

}  // namespace zona::beam
