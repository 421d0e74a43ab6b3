#include "beam/algebra/symmetric_band.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "beam/algebra/require.h"

namespace zona::beam {

SymmetricBand::SymmetricBand(int size) {
  for (auto& diagonal : diagonal_) diagonal = Eigen::VectorXd::Zero(size);
}

void SymmetricBand::add(int row, int column, double value) {
  const int low = std::min(row, column);
  const int high = std::max(row, column);
  if (low < 0 || high >= size() || high - low > half_bandwidth)
    throw std::out_of_range(fmt::format(
        "band matrix: entry ({}, {}) lies outside the half bandwidth {} of a matrix of size {}; "
        "number the degrees of freedom along the beam",
        row, column, half_bandwidth, size()));
  diagonal_[high - low](high) += value;
}

double SymmetricBand::operator()(int row, int column) const {
  const int distance = std::abs(row - column);
  return distance > half_bandwidth ? 0 : diagonal_[distance](std::max(row, column));
}

void SymmetricBand::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& result) const {
  result.array() = diagonal_[0].array() * x.array();
  const int n = size();
  for (int k = 1; k <= half_bandwidth && k < n; ++k) {
    const auto band = diagonal_[k].tail(n - k).array();
    result.tail(n - k).array() += band * x.head(n - k).array();
    result.head(n - k).array() += band * x.tail(n - k).array();
  }
}

void SymmetricBand::combine(double a, const SymmetricBand& A, double b, const SymmetricBand& B) {
  for (int k = 0; k <= half_bandwidth; ++k) diagonal_[k] = a * A.diagonal_[k] + b * B.diagonal_[k];
}

void SymmetricBand::accumulate(double a, const SymmetricBand& A) {
  for (int k = 0; k <= half_bandwidth; ++k) diagonal_[k] += a * A.diagonal_[k];
}

Eigen::MatrixXd SymmetricBand::dense() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size(), size());
  for (int row = 0; row < size(); ++row)
    for (int column = std::max(0, row - half_bandwidth); column <= row; ++column)
      matrix(row, column) = matrix(column, row) = (*this)(row, column);
  return matrix;
}

void BandFactor::factorise(const SymmetricBand& matrix) {
  for (int k = 0; k <= half_bandwidth; ++k) lower_[k] = matrix.diagonal_[k];
  auto& [inverse, one, two, three] = lower_;
  for (int i = 0; i < matrix.size(); ++i) {
    // Row i of L D, then of L; coefficients before column 0 are zero in the diagonals.
    if (i >= 2) two(i) -= i >= 3 ? three(i) * one(i - 2) : 0;
    if (i >= 1) one(i) -= (i >= 3 ? three(i) * two(i - 1) : 0) + (i >= 2 ? two(i) * one(i - 1) : 0);
    double pivot = inverse(i);
    for (int k = 1; k <= std::min(i, half_bandwidth); ++k) {
      const double unscaled = lower_[k](i);
      lower_[k](i) = unscaled * inverse(i - k);
      pivot -= unscaled * lower_[k](i);
    }
    require(pivot > 0,
            fmt::format("band matrix: pivot {} of row {} is not positive; the beam needs "
                        "positive mass and rigidity everywhere and enough supports",
                        pivot, i));
    inverse(i) = 1 / pivot;
  }
}

void BandFactor::solve_in_place(Eigen::VectorXd& x) const {
  const auto& [inverse, one, two, three] = lower_;
  const int n = static_cast<int>(x.size());
  double x1 = 0, x2 = 0, x3 = 0;
  for (int i = 0; i < n; ++i) {
    const double value = (x(i) - three(i) * x3 - two(i) * x2) - one(i) * x1;
    x3 = x2, x2 = x1, x1 = value;
    x(i) = value;
  }
  x.array() *= inverse.array();
  x1 = x2 = x3 = 0;
  double one1 = 0, two1 = 0, two2 = 0, three1 = 0, three2 = 0, three3 = 0;
  for (int i = n - 1; i >= 0; --i) {
    const double value = (x(i) - three3 * x3 - two2 * x2) - one1 * x1;
    x3 = x2, x2 = x1, x1 = value;
    x(i) = value;
    three3 = three2, three2 = three1, three1 = three(i);
    two2 = two1, two1 = two(i), one1 = one(i);
  }
}

}  // namespace zona::beam
