#pragma once

#include <omp.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <vector>

#include "mpm/grid/background_grid.h"

namespace zona::mpm {

/// Gives the bricks of a grid to threads. Bricks that share nodes are worked on one after the
/// other, in the order of their colours, by whichever threads: sums over their points are added in
/// one order. A brick waits for these neighbours alone, never for all bricks of a colour.
class BrickSchedule {
 public:
  /// Shares the bricks of a grid out evenly.
  BrickSchedule(const BackgroundGrid& grid, int threads);

  int threads() const { return threads_; }  ///< that work
  /// Shares the bricks out by their costs: a thread gets bricks that lie side by side, so that
  /// their points and nodes stay in its caches.
  void share(const std::vector<double>& cost);

  /// f(brick) for all bricks, those that share nodes in the order of their colours.
  template <class F>
  void in_order(F f);
  /// f(brick) for all bricks, for what does not write to nodes.
  template <class F>
  void in_any_order(F f);

  /// From now on the wall time of each brick is taken in `in_order`, until it is asked for.
  void start_timing();
  bool is_timing() const { return is_timing_; }  ///< between `start_timing` and `stop_timing`
  /// Wall time that each brick took since then [s].
  std::vector<double> stop_timing();

 private:
  /// Rounds without a brick to work on before the processor is given away.
  static constexpr int patience = 200;

  bool is_ready(int brick) const;
  template <class F>
  void work_on(int brick, F& f);

  int threads_;
  std::vector<int> by_colour_;                 ///< all bricks
  std::vector<std::vector<int>> neighbours_;   ///< of each brick, those of lower colours
  std::vector<std::vector<int>> share_;        ///< of each thread, in the order of colours
  std::vector<std::vector<int>> pending_;      ///< of each thread in the running pass
  std::unique_ptr<std::atomic<long>[]> done_;  ///< the last pass that is through with each brick
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
        if (idle > patience) sched_yield();
      }
    } else if (thread == 0) {  // fewer threads than asked for: nobody to wait for
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
