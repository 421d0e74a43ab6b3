#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace zona::studies {

class Progress;

/// Threads of a parallel loop.
struct Threads {
  int items = 1;     ///< items at a time
  int per_item = 1;  ///< OpenMP threads within an item
};

/// A loop over the items 0, 1, ..., count - 1 in threads of its own, beside the caller. Items begin
/// in this order; all of them run, also after one has failed. An action must write to the slot of
/// its item only, then results do not depend on the number of threads.
class ParallelLoop {
 public:
  using Action = std::function<void(std::size_t item)>;

  /// Begins the loop.
  ParallelLoop(std::size_t count, Threads threads, Action action);
  /// Waits for the end of the loop.
  ~ParallelLoop();
  ParallelLoop(const ParallelLoop&) = delete;
  ParallelLoop& operator=(const ParallelLoop&) = delete;

  /// Waits for the end of the loop.
  void join();
  /// After the end: throws what the first failed item, by number, has thrown.
  void rethrow() const;

 private:
  void work(int openmp_threads);

  Action action_;
  std::vector<std::exception_ptr> failures_;  ///< of each item
  std::atomic<std::size_t> next_{0};
  std::vector<std::thread> threads_;
};

/// A `ParallelLoop` from its beginning to its end. Throws the failure of the first failed item.
void parallel_for(std::size_t count, Threads threads, const ParallelLoop::Action& action);

/// The same as a stage of `progress` that counts the items, one OpenMP thread each. `action`
/// returns a text that the user sees when its item is done. After an interrupt no further item
/// begins.
void parallel_stage(const std::string& label, std::size_t count, int threads, Progress& progress,
                    const std::function<std::string(std::size_t item)>& action);

}  // namespace zona::studies
