#include "mpm/step/brick_schedule.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <memory>

using namespace zona::mpm;

namespace {

/// When each brick was done, and how often, in a pass.
struct Pass {
  explicit Pass(std::size_t bricks)
      : count(new std::atomic<int>[bricks]), begun(bricks), ended(bricks) {
    for (std::size_t b = 0; b < bricks; ++b) count[b] = 0;
  }
  void operator()(int b) {
    begun[b] = ++clock;
    ++count[b];
    ended[b] = ++clock;
  }
  std::unique_ptr<std::atomic<int>[]> count;
  std::vector<int> begun, ended;
  std::atomic<int> clock{0};
};

bool share_nodes(const Brick& a, const Brick& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(a.first_cell[axis] - b.first_cell[axis]) > Brick::edge) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("Every brick is done once, after those of lower colours that it shares nodes with") {
  const int threads = GENERATE(1, 2, 3, 7);
  const BackgroundGrid grid(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones(), {13, 17, 9});
  const auto& bricks = grid.bricks();
  std::vector<int> colour(bricks.size());
  for (int c = 0; c < 8; ++c) {
    for (int b : grid.bricks_by_colour()[c]) colour[b] = c;
  }
  BrickSchedule schedule(grid, threads);
  for (int round = 0; round < 20; ++round) {
    // Shares of all kinds, also such that some threads have nothing.
    std::vector<double> cost(bricks.size());
    for (std::size_t b = 0; b < cost.size(); ++b) cost[b] = 1 + (round * b) % 5;
    if (round % 4 == 3) cost[round] = 1e6;
    schedule.share(cost);
    Pass pass(bricks.size());
    schedule.in_order([&](int b) { pass(b); });
    for (std::size_t a = 0; a < bricks.size(); ++a) {
      REQUIRE(pass.count[a] == 1);
      for (std::size_t b = 0; b < bricks.size(); ++b) {
        if (colour[a] < colour[b] && share_nodes(bricks[a], bricks[b]))
          REQUIRE(pass.ended[a] < pass.begun[b]);
      }
    }
    Pass any(bricks.size());
    schedule.in_any_order([&](int b) { any(b); });
    for (std::size_t a = 0; a < bricks.size(); ++a) REQUIRE(any.count[a] == 1);
  }
}

TEST_CASE("The time of bricks is measured on request") {
  const BackgroundGrid grid(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones(), {8, 8, 8});
  BrickSchedule schedule(grid, 2);
  CHECK_FALSE(schedule.is_timing());
  schedule.start_timing();
  CHECK(schedule.is_timing());
  schedule.in_order([](int b) {
    const auto start = std::chrono::steady_clock::now();
    while (b == 5 && std::chrono::steady_clock::now() - start < std::chrono::milliseconds(2)) {
    }
  });
  const std::vector<double> seconds = schedule.stop_timing();
  CHECK_FALSE(schedule.is_timing());
  REQUIRE(seconds.size() == 8);
  for (double s : seconds) CHECK(s >= 0);
  CHECK(seconds[5] >= 2e-3);
}
