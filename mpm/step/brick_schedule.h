#pragma once

#include <omp.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <vector>

#include "mpm/grid/background_grid.h"

namespace zona::mpm {

/// Distributes the bricks of a grid to threads. Bricks that share nodes are processed one after the
/// other in the order of their colours, which fixes the order of all sums. A brick waits only for
/// its neighbours, never for all bricks of a colour.
class BrickSchedule {
 public:
  /// Distributes the bricks evenly.
  BrickSchedule(const BackgroundGrid& grid, int threads);

  int threads() const { return threads_; }  ///< number of threads
  /// Distributes the bricks by their costs. A thread gets adjacent bricks, whose points and nodes
  /// stay in its caches.
  void share(const std::vector<double>& cost);

  /// Calls f(brick) for all bricks; bricks that share nodes follow the order of their colours.
  template <class F>
  void in_order(F f);
  /// Calls f(brick) for all bricks in any order; f must not write to nodes.
  template <class F>
  void in_any_order(F f);

  /// Starts to measure the wall time of each brick in `in_order`.
  void start_timing();
  bool is_timing() const { return is_timing_; }  ///< between `start_timing` and `stop_timing`
  /// Stops measuring and returns the wall time of each brick [s].
  std::vector<double> stop_timing();

 private:
  /// Rounds without a ready brick before the thread yields the processor.
  static constexpr int max_idle_rounds = 200;

  bool is_ready(int brick) const;
  template <class F>
  void work_on(int brick, F& f);

  int threads_;
  std::vector<int> by_colour_;                 ///< all bricks
  std::vector<std::vector<int>> neighbours_;   ///< per brick, those of lower colours
  std::vector<std::vector<int>> share_;        ///< per thread, in the order of colours
  std::vector<std::vector<int>> pending_;      ///< per thread, in the current pass
  std::unique_ptr<std::atomic<long>[]> done_;  ///< per brick, the last finished pass
  long pass_ = 0;
  bool is_timing_ = false;
  std::vector<double> seconds_;
};

inline bool BrickSchedule::is_ready(int brick) const {
  for (int n : neighbours_[brick]) {
    if (done_[n].load(std::memory_order_acquire) < pass_) return false;
  }
  return true;
}

template <class F>
void BrickSchedule::work_on(int brick, F& f) {
  if (is_timing_) {
    const auto start = std::chrono::steady_clock::now();
    f(brick);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    seconds_[brick] += spent.count();
  } else {
    f(brick);
  }
  done_[brick].store(pass_, std::memory_order_release);
}

template <class F>
void BrickSchedule::in_order(F f) {
  ++pass_;
#pragma omp parallel num_threads(threads_)
  {
    const int thread = omp_get_thread_num();
    if (omp_get_num_threads() == threads_) {
      auto& pending = pending_[thread];
      pending = share_[thread];
      for (int idle = 0; !pending.empty();) {
        std::size_t left = 0;
        for (int b : pending) {
          if (is_ready(b))
            work_on(b, f);
          else
            pending[left++] = b;
        }
        idle = left == pending.size() ? idle + 1 : 0;
        pending.resize(left);
        if (idle > max_idle_rounds) sched_yield();
      }
    } else if (thread == 0) {  // fewer threads than requested: one thread does all bricks
      for (int b : by_colour_) work_on(b, f);
    }
  }
}

template <class F>
void BrickSchedule::in_any_order(F f) {
#pragma omp parallel for num_threads(threads_) schedule(static, 1)
  for (int t = 0; t < threads_; ++t) {
    for (int b : share_[t]) f(b);
  }
}

}  // namespace zona::mpm
