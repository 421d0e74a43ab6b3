#include "mpm/grid/shape_functions.h"

#include <catch2/catch.hpp>
#include <random>

using namespace zona::mpm;

TEST_CASE("Transposing eight rows of lanes twice gives them back") {
  Lanes rows[8];
  for (int r = 0; r < 8; ++r) {
    for (int l = 0; l < 8; ++l) rows[r][l] = 10 * r + l;
  }
  transpose(rows);
  for (int r = 0; r < 8; ++r) {
    for (int l = 0; l < 8; ++l) CHECK(rows[r][l] == 10 * l + r);
  }
}

TEST_CASE("Trilinear shape functions sum to one and reproduce linear fields") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 100; ++trial) {
    const double s[3] = {unit(random), unit(random), unit(random)};
    const auto f = trilinear::factors(s[0], s[1], s[2]);
    const Lanes shape = f.x * f.y * f.z;
    const Lanes gradient[3] = {trilinear::sign_x * f.y * f.z, trilinear::sign_y * f.x * f.z,
                               trilinear::sign_z * f.x * f.y};
    double sum = 0, place[3] = {0, 0, 0}, slope_sum[3] = {0, 0, 0}, slope[3][3] = {};
    for (int n = 0; n < 8; ++n) {
      sum += shape[n];
      for (int i = 0; i < 3; ++i) {
        const int corner = (n >> i) & 1;
        place[i] += shape[n] * corner;
        slope_sum[i] += gradient[i][n];
        for (int j = 0; j < 3; ++j) slope[i][j] += gradient[j][n] * corner;
      }
    }
    // Eight terms of order one: a few ulp.
    CHECK(sum == Approx(1).epsilon(1e-15));
    for (int i = 0; i < 3; ++i) {
      CHECK(place[i] == Approx(s[i]).margin(1e-15));
      CHECK(std::abs(slope_sum[i]) < 1e-15);
      for (int j = 0; j < 3; ++j) CHECK(slope[i][j] == Approx(i == j ? 1 : 0).margin(1e-15));
    }
  }
}

TEST_CASE("Coefficients give the same interpolation and derivatives as shape functions") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  double node[8], c[8];
  for (int n = 0; n < 8; ++n) c[n] = node[n] = unit(random);
  trilinear::to_coefficients(c);
  const double s[3] = {unit(random), unit(random), unit(random)};
  const std::array<Lanes, 3> natural{broadcast(s[0]), broadcast(s[1]), broadcast(s[2])};
  const auto f = trilinear::factors(s[0], s[1], s[2]);
  double value = 0, slope[3] = {0, 0, 0};
  for (int n = 0; n < 8; ++n) {
    value += node[n] * f.x[n] * f.y[n] * f.z[n];
    slope[0] += node[n] * trilinear::sign_x[n] * f.y[n] * f.z[n];
    slope[1] += node[n] * trilinear::sign_y[n] * f.x[n] * f.z[n];
    slope[2] += node[n] * trilinear::sign_z[n] * f.x[n] * f.y[n];
  }
  CHECK(trilinear::interpolate(c, 1, natural)[3] == Approx(value).epsilon(1e-14));
  const auto derivative = trilinear::derivatives(c, 1, natural);
  for (int i = 0; i < 3; ++i) CHECK(derivative[i][5] == Approx(slope[i]).epsilon(1e-13));
}

namespace {

BackgroundGrid quadratic_grid() {
  return {{-1, 2, 0}, {0.5, 0.4, 0.3}, {5, 2, 1}, Interpolation::quadratic};
}

Cell cell_at(const BackgroundGrid& grid, const Eigen::Vector3d& x) {
  const auto cell = grid.cell_at(x.x(), x.y(), x.z());
  return make_cell(grid, grid.bricks()[grid.brick_of(cell)], BackgroundGrid::cell_in_brick(cell));
}

std::array<Lanes, 3> natural(const Cell& cell, const Eigen::Vector3d& x) {
  return cell.natural({broadcast(x.x()), broadcast(x.y()), broadcast(x.z())});
}

/// Contribution of the vector (1, 2, 3) at x to each node.
std::vector<double> nodal_shares(const BackgroundGrid& grid, const Eigen::Vector3d& x) {
  const Cell cell = cell_at(grid, x);
  Quadratic::VectorSums sums(grid, cell);
  PointVectors at{};
  for (int axis = 0; axis < 3; ++axis) {
    at.natural[axis][0] = natural(cell, x)[axis][0];
    at.vector[axis][0] = axis + 1;
  }
  sums.add(at, 0);
  std::vector<double> shares(grid.node_count(), 0.0);
  sums.for_each_node(cell, grid, [&](int node, const HalfLanes& sum) {
    shares.at(node) = sum[0];
    CHECK(sum[2] == Approx(3 * sum[0]).epsilon(1e-14));
  });
  return shares;
}

/// Calls f(x) for places all over the grid.
template <class F>
void for_random_places(const BackgroundGrid& grid, int count, F f) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const Eigen::Vector3d size = grid.upper_corner() - grid.origin();
  for (int i = 0; i < count; ++i) {
    f(grid.origin() + size.cwiseProduct(Eigen::Vector3d(unit(random), unit(random), unit(random))));
  }
}

}  // namespace

TEST_CASE("Quadratic splines are positive, sum to one and reproduce linear fields") {
  const BackgroundGrid grid = quadratic_grid();
  CHECK(grid.nodes_along() == std::array<int, 3>{7, 4, 3});
  const auto& along = grid.nodes_along();
  for_random_places(grid, 200, [&](const Eigen::Vector3d& x) {
    const auto shares = nodal_shares(grid, x);
    double sum = 0;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (int k = 0; k < along[2]; ++k) {
      for (int j = 0; j < along[1]; ++j) {
        for (int i = 0; i < along[0]; ++i) {
          const double share = shares[grid.node_index(i, j, k)];
          CHECK(share >= 0);
          sum += share;
          place += share * grid.node_position(i, j, k);
        }
      }
    }
    // 27 terms of order one.
    CHECK(sum == Approx(1).epsilon(1e-14));
    CHECK((place - x).norm() < 1e-14);
  });
}

TEST_CASE("At a face of the grid only the outermost quadratic functions are left") {
  const BackgroundGrid grid = quadratic_grid();
  const double almost = 1e-9;
  const auto low = nodal_shares(grid, {-1 + almost, 2.3, 0.1});
  double on_face = 0;
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 4; ++j) on_face += low[grid.node_index(0, j, k)];
  }
  CHECK(on_face == Approx(1).epsilon(1e-8));
  CHECK(grid.node_position(0, 0, 0) == grid.origin());
  CHECK(grid.node_position(6, 3, 2) == grid.upper_corner());
  CHECK(grid.node_position(2, 2, 1).isApprox(Eigen::Vector3d(-0.25, 2.6, 0.15)));
}

TEST_CASE("Velocity and gradient of quadratic fields: exact, and smooth from cell to cell") {
  BackgroundGrid grid = quadratic_grid();
  std::mt19937 random(6);
  std::uniform_real_distribution<double> value(-1, 1);
  for (std::size_t n = 0; n < grid.node_count(); ++n) {
    for (int i = 0; i < 3; ++i) grid.updated[n][i] = grid.state[n][1 + i] = value(random);
  }
  const auto velocity = [&](const Eigen::Vector3d& x, int axis) {
    const Cell cell = cell_at(grid, x);
    return Quadratic::CellField(grid, cell).velocity(axis, natural(cell, x))[4];
  };
  const auto gradient = [&](const Eigen::Vector3d& x) {
    const Cell cell = cell_at(grid, x);
    return Quadratic::CellGradient(grid, cell).at(natural(cell, x));
  };
  for_random_places(grid, 50, [&](const Eigen::Vector3d& x) {
    const auto shares = nodal_shares(grid, x);
    double sum = 0;
    for (std::size_t n = 0; n < shares.size(); ++n) sum += shares[n] * grid.state[n][2];
    CHECK(velocity(x, 1) == Approx(sum).margin(1e-14));
    // Central differences are exact for the quadratics of one cell.
    const double step = 1e-4;
    const Cell cell = cell_at(grid, x);
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d d = step * Eigen::Vector3d::Unit(j);
      if (std::abs(natural(cell, x)[j][0] - 0.5) > 0.499) continue;
      for (int i = 0; i < 3; ++i) {
        CHECK(gradient(x)[i][j][0] ==
              Approx((velocity(x + d, i) - velocity(x - d, i)) / (2 * step)).margin(1e-9));
      }
    }
  });
  const double apart = 1e-9;
  for (double face : {-0.5, 0.0, 0.5, 1.0}) {
    const auto left = gradient({face - apart, 2.37, 0.11});
    const auto right = gradient({face + apart, 2.37, 0.11});
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        CHECK(left[i][j][0] == Approx(right[i][j][0]).margin(100 * apart));
    }
  }
}

TEST_CASE("Nodal sums of quadratic functions: mass, momentum and the work of the stress") {
  BackgroundGrid grid = quadratic_grid();
  std::mt19937 random(8);
  std::uniform_real_distribution<double> value(-1, 1);
  for (auto& node : grid.updated) node = HalfLanes{value(random), value(random), value(random)};
  double work = 0;
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  for_random_places(grid, 40, [&](const Eigen::Vector3d& x) {
    const Cell cell = cell_at(grid, x);
    PointContributions loads{};
    loads.mass[3] = 2;
    double sigma[3][3];
    for (int i = 0; i < 3; ++i) {
      loads.natural[i][3] = natural(cell, x)[i][0];
      momentum[i] += loads.momentum[i][3] = value(random);
      for (int j = 0; j <= i; ++j) sigma[i][j] = sigma[j][i] = value(random);
    }
    const auto l = Quadratic::CellGradient(grid, cell).at(natural(cell, x));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        loads.stress[i][j][3] = -sigma[i][j] * cell.inverse[j];
        work += sigma[i][j] * l[i][j][0];
      }
    }
    Quadratic::NodalSums sums(grid, cell);
    sums.add<true>(loads, 3);
    sums.add_to_nodes(cell, 5, 0, grid);
  });
  double mass = 0, power = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t n = 0; n < grid.node_count(); ++n) {
    const Lanes& state = grid.state[n];
    mass += state[0];
    CHECK(state[7] == Approx(5 * state[0]));
    for (int i = 0; i < 3; ++i) {
      sum[i] += state[1 + i];
      power += state[4 + i] * grid.updated[n][i];
    }
  }
  CHECK(mass == Approx(80).epsilon(1e-14));
  CHECK((sum - momentum).norm() < 1e-13);
  CHECK(power == Approx(-work).epsilon(1e-12));
}
