#include "studies/run/parallel.h"

#include <omp.h>

#include <algorithm>
#include <mutex>

#include "studies/run/interrupt.h"
#include "studies/run/progress.h"

namespace zona::studies {

ParallelLoop::ParallelLoop(std::size_t count, Threads threads, Action action)
    : action_(std::move(action)), failures_(count) {
  const std::size_t workers = std::min<std::size_t>(count, std::max(threads.items, 1));
  for (std::size_t w = 0; w < workers; ++w)
    threads_.emplace_back([this, threads] { work(std::max(threads.per_item, 1)); });
}

ParallelLoop::~ParallelLoop() {
  join();
}

void ParallelLoop::work(int openmp_threads) {
  omp_set_num_threads(openmp_threads);
  for (std::size_t item; (item = next_++) < failures_.size();) {
    try {
      action_(item);
    } catch (...) {
      failures_[item] = std::current_exception();
    }
  }
}

void ParallelLoop::join() {
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void ParallelLoop::rethrow() const {
  for (const std::exception_ptr& failure : failures_)
    if (failure) std::rethrow_exception(failure);
}

void parallel_for(std::size_t count, Threads threads, const ParallelLoop::Action& action) {
  ParallelLoop loop(count, threads, action);
  loop.join();
  loop.rethrow();
}

void parallel_stage(const std::string& label, std::size_t count, int threads, Progress& progress,
                    const std::function<std::string(std::size_t item)>& action) {
  std::mutex mutex;
  int done = 0;
  progress.start(label, static_cast<double>(count));
  ParallelLoop loop(count, {threads, 1}, [&](std::size_t item) {
    if (Interrupt::requested()) return;
    const std::string text = action(item);
    const std::lock_guard lock(mutex);
    progress.update(++done, 0, text);
  });
  loop.join();
  progress.finish();
  loop.rethrow();
}

}  // namespace zona::studies
