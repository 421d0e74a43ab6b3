#pragma once

#include <omp.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <vector>

#include "mpm/background_grid.h"

namespace zona::mpm {

/// Gives the bricks of a grid to threads. Bricks that share nodes are worked on one after the
/// other, in the order of their colours, by whichever threads: sums over their points are added in
/// one order. A brick waits for these neighbours alone, never for all bricks of a colour.
class BrickSchedule {
 public:
  BrickSchedule(const BackgroundGrid& grid, int threads);

  int threads() const { return threads_; }
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
  bool is_timing() const { return is_timing_; }
  /// Wall time that each brick took since then [s].
  std::vector<double> stop_timing();

 private:
  void wait_for(int brick) const;

  int threads_;
  std::vector<int> by_colour_;                 ///< all bricks
  std::vector<std::vector<int>> neighbours_;   ///< of each brick, those of lower colours
  std::vector<std::vector<int>> share_;        ///< of each thread, in the order of colours
  std::vector<std::vector<int>> foreign_;      ///< those neighbours that other threads have
  std::unique_ptr<std::atomic<long>[]> done_;  ///< the last pass that is through with each brick
  long pass_ = 0;
  bool is_timing_ = false;
  std::vector<double> seconds_;
};

inline void BrickSchedule::wait_for(int brick) const {
  constexpr int patience = 2000;
  for (int n : foreign_[brick]) {
    for (int tries = 0; done_[n].load(std::memory_order_acquire) < pass_; ++tries) {
      if (tries > patience) sched_yield();
    }
  }
}

template <class F>
void BrickSchedule::in_order(F f) {
  ++pass_;
#pragma omp parallel num_threads(threads_)
  {
    const bool is_whole_team = omp_get_num_threads() == threads_;
    const int thread = omp_get_thread_num();
    const std::vector<int>* bricks = &share_[thread];
    // Fewer threads than asked for could wait for one that is not there.
    static const std::vector<int> none;
    if (!is_whole_team) bricks = thread == 0 ? &by_colour_ : &none;
    for (int b : *bricks) {
      if (is_whole_team) wait_for(b);
      if (is_timing_) {
        const auto start = std::chrono::steady_clock::now();
        f(b);
        seconds_[b] +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      } else {
        f(b);
      }
      done_[b].store(pass_, std::memory_order_release);
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
