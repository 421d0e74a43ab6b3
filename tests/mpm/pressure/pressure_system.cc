#include "mpm/pressure/pressure_system.h"

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>
#include <random>

using namespace zona::mpm;

namespace {

/// Sums of 8 to 20 points at random places of a cell of one metre.
FluidSums random_sums(std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, 1);
  FluidSums sums;
  const int count = 8 + static_cast<int>(random() % 13);
  for (int p = 0; p < count; ++p) {
    const double x[3] = {place(random), place(random), place(random)};
    const double v = 1.0 / count;
    sums.volume += v;
    for (int i = 0; i < 3; ++i) {
      sums.moment[i] += v * x[i];
      sums.moment[3 + i] += v * x[i] * x[(i + 1) % 3];
    }
  }
  return sums;
}

/// Volume times gradient of the shape function of a cell's node, summed over the points (3.7).
double summed_gradient(const FluidSums& s, int node, int axis) {
  const int u = axis == 0 ? 1 : 0;
  const int w = axis == 2 ? 1 : 2;
  const double uw = s.moment[3 + (axis + 1) % 3];
  const auto bit = [&](int a) { return node >> a & 1; };
  // (far or near) x (s_u or 1 - s_u) x (s_w or 1 - s_w)
  double sum = bit(u) && bit(w) ? uw
               : bit(u)         ? s.moment[u] - uw
               : bit(w)         ? s.moment[w] - uw
                                : s.volume - s.moment[u] - s.moment[w] + uw;
  return bit(axis) ? sum : -sum;
}

/// Two fluids in boxes that overlap in a layer of cells, with random points and mobilities; some
/// nodes are held.
struct RandomSystem {
  std::array<int, 3> cells{7, 5, 6};
  CellLattice lattice{cells};
  PressureSystem system;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right, pressure;
  std::vector<std::pair<int, long>> unknowns;  ///< fluid and place

  explicit RandomSystem(int threads) : system(lattice, 2, threads) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0.5, 2);
    for (int k = 0; k <= cells[2]; ++k) {
      for (int j = 0; j <= cells[1]; ++j) {
        for (int i = 0; i <= cells[0]; ++i) {
          for (auto& m : system.mobility)
            m[lattice.place(i, j, k)] = random() % 9 == 0 ? 0.0f : static_cast<float>(part(random));
        }
      }
    }
    std::vector<std::vector<double>> rows;
    std::vector<double> compliances;
    for (int f = 0; f < 2; ++f) {
      auto& fluid = system.fluids[f];
      std::fill(fluid.occupied_chunk.begin(), fluid.occupied_chunk.end(), 1);
      for (int k = 0; k < cells[2]; ++k) {
        for (int j = 0; j < cells[1]; ++j) {
          for (int i = f == 0 ? 0 : 3; i < (f == 0 ? 4 : cells[0]); ++i) {
            const long c = lattice.place(i, j, k);
            const FluidSums sums = random_sums(random);
            fluid.gradient.set(c, sums, {1, 1, 1});
            fluid.compliance[c] = 1e-2 * part(random);
            fluid.right[c] = part(random) - 1;
            unknowns.push_back({f, c});
            compliances.push_back(fluid.compliance[c]);
            rows.push_back(row_of(sums, c));
          }
        }
      }
    }
    const auto n = static_cast<int>(rows.size());
    Eigen::MatrixXd g(n, 3 * lattice.size);
    Eigen::VectorXd m(3 * lattice.size);
    right.resize(n);
    for (int r = 0; r < n; ++r) {
      g.row(r) = Eigen::Map<Eigen::RowVectorXd>(rows[r].data(), 3 * lattice.size);
      right[r] = system.fluids[unknowns[r].first].right[unknowns[r].second];
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (long p = 0; p < lattice.size; ++p) m[axis * lattice.size + p] = system.mobility[axis][p];
    }
    matrix = g * m.asDiagonal() * g.transpose();
    for (int r = 0; r < n; ++r) matrix(r, r) += compliances[r];
    pressure = matrix.ldlt().solve(right);
  }

  std::vector<double> row_of(const FluidSums& sums, long c) const {
    std::vector<double> row(3 * lattice.size, 0.0);
    for (int node = 0; node < 8; ++node) {
      const long at = c + (node & 1) + (node >> 1 & 1) * lattice.row + (node >> 2) * lattice.layer;
      for (int axis = 0; axis < 3; ++axis)
        row[axis * lattice.size + at] += summed_gradient(sums, node, axis);
    }
    return row;
  }
  Eigen::VectorXd solution() const {
    Eigen::VectorXd q(unknowns.size());
    for (std::size_t r = 0; r < unknowns.size(); ++r)
      q[r] = system.fluids[unknowns[r].first].pressure[unknowns[r].second];
    return q;
  }
};

}  // namespace

TEST_CASE("Pressures solve the system assembled from shape functions") {
  RandomSystem random(2);
  const auto outcome = random.system.solve(random.right.norm(), 1e-10);
  CHECK(outcome.converged);
  // Coefficients are rounded to single precision, 6e-8, and the condition number is some 1e3.
  CHECK((random.solution() - random.pressure).norm() < 1e-4 * random.pressure.norm());
  CHECK((random.matrix * random.solution() - random.right).norm() < 1e-6 * random.right.norm());
}

TEST_CASE("A solution meets the tolerance, and starts from the pressures that stand") {
  int last = 0;
  for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-9}) {
    RandomSystem random(1);
    const auto outcome = random.system.solve(random.right.norm(), tolerance);
    CHECK(outcome.converged);
    CHECK(outcome.residual <= tolerance);
    CHECK(outcome.iterations > last);
    last = outcome.iterations;
    CHECK(random.system.solve(random.right.norm(), tolerance).iterations == 0);
  }
}

TEST_CASE("Any number of threads solves to the same bits") {
  RandomSystem one(1);
  one.system.solve(one.right.norm(), 1e-6);
  for (const int threads : {2, 3}) {
    RandomSystem many(threads);
    many.system.solve(many.right.norm(), 1e-6);
    CHECK(many.solution() == one.solution());
  }
}

TEST_CASE("Forces of pressures have no resultant") {
  RandomSystem random(1);
  random.system.solve(random.right.norm(), 1e-6);
  for (const Field& force : random.system.forces()) {
    double sum = 0;
    double all = 0;
    for (const double f : force) {
      sum += f;
      all += std::abs(f);
    }
    CHECK(std::abs(sum) < 1e-13 * all);
  }
}
