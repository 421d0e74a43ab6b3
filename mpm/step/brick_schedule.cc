#include "mpm/step/brick_schedule.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace zona::mpm {

BrickSchedule::BrickSchedule(const BackgroundGrid& grid, int threads)
    : threads_(threads),
      neighbours_(grid.bricks().size()),
      done_(new std::atomic<long>[grid.bricks().size()]) {
  const int count = static_cast<int>(grid.bricks().size());
  std::vector<int> colour_of(count);
  for (int colour = 0; colour < 8; ++colour) {
    for (int b : grid.bricks_by_colour()[colour]) {
      by_colour_.push_back(b);
      colour_of[b] = colour;
    }
  }
  std::array<int, 3> along;
  for (int axis = 0; axis < 3; ++axis)
    along[axis] = (grid.cells()[axis] + Brick::edge - 1) / Brick::edge;
  for (int b = 0; b < count; ++b) {
    done_[b] = 0;
    const int x = b % along[0], y = b / along[0] % along[1], z = b / (along[0] * along[1]);
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, along[2] - 1); ++k) {
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, along[1] - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, along[0] - 1); ++i) {
          const int n = (k * along[1] + j) * along[0] + i;
          if (colour_of[n] < colour_of[b]) neighbours_[b].push_back(n);
        }
      }
    }
  }
  share(std::vector<double>(count, 1.0));
}

void BrickSchedule::share(const std::vector<double>& cost) {
  const double total = std::accumulate(cost.begin(), cost.end(), 0.0);
  std::vector<int> owner(cost.size());
  double before = 0;
  for (std::size_t b = 0; b < cost.size(); ++b) {
    const double middle = (before + 0.5 * cost[b]) / total;
    owner[b] = std::clamp(static_cast<int>(middle * threads_), 0, threads_ - 1);
    before += cost[b];
  }
  share_.assign(threads_, {});
  pending_.resize(threads_);
  for (int b : by_colour_) share_[owner[b]].push_back(b);
}

void BrickSchedule::start_timing() {
  seconds_.assign(neighbours_.size(), 0.0);
  is_timing_ = true;
}

std::vector<double> BrickSchedule::stop_timing() {
  is_timing_ = false;
  return std::move(seconds_);
}

}  // namespace zona::mpm
