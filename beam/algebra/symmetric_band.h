#pragma once

#include <Eigen/Core>
#include <array>

namespace zona::beam {

/// Degrees of freedom of an element differ by at most three.
constexpr int half_bandwidth = 3;

/// Symmetric banded matrix of half bandwidth 3, stored by diagonals.
class SymmetricBand {
 public:
  SymmetricBand() = default;
  /// A zero matrix of `size` rows.
  explicit SymmetricBand(int size);

  int size() const { return static_cast<int>(diagonal_[0].size()); }  ///< rows

  /// Adds to entry (row, column) = (column, row); throws std::out_of_range outside the band.
  void add(int row, int column, double value);

  /// Entry (row, column), zero outside the band.
  double operator()(int row, int column) const;

  /// result = A x, without allocation. The two must not be the same vector.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& result) const;

  /// this = a A + b B for two matrices of this size, without allocation.
  void combine(double a, const SymmetricBand& A, double b, const SymmetricBand& B);

  /// this += a A, without allocation.
  void accumulate(double a, const SymmetricBand& A);

  /// Entries (i, i - k) of the diagonal k <= half_bandwidth; its first k values are zero.
  const Eigen::VectorXd& diagonal(int k) const { return diagonal_[k]; }

  /// Copy as a full matrix.
  Eigen::MatrixXd dense() const;

 private:
  friend class BandFactor;
  /// diagonal_[k](i) is entry (i, i - k); the first k values of diagonal k are zero.
  std::array<Eigen::VectorXd, half_bandwidth + 1> diagonal_;
};

/// L D L^T factors of a positive definite SymmetricBand. Factorising takes one division per row,
/// solving none.
class BandFactor {
 public:
  BandFactor() = default;
  /// See `factorise`.
  explicit BandFactor(const SymmetricBand& matrix) { factorise(matrix); }

  /// Allocates only if the size changes. Throws std::invalid_argument with the row if the matrix is
  /// not positive definite.
  void factorise(const SymmetricBand& matrix);

  /// Replaces the right-hand side by the solution, without allocation.
  void solve_in_place(Eigen::VectorXd& x) const;

 private:
  std::array<Eigen::VectorXd, half_bandwidth + 1> lower_;  ///< lower_[0] holds 1 / D
};

}  // namespace zona::beam
