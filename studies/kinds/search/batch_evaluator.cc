#include "studies/kinds/search/batch_evaluator.h"

#include <algorithm>
#include <exception>

namespace zona::studies::search {

nlohmann::json BatchEvaluator::evaluate(std::size_t caller, const Configuration& piercing) {
  std::unique_lock lock(mutex_);
  questions_[caller] = piercing;
  changed_.notify_all();
  changed_.wait(lock, [&] { return answers_[caller].has_value(); });
  nlohmann::json answer = std::move(*answers_[caller]);
  answers_[caller].reset();
  return answer;
}

void BatchEvaluator::leave(std::size_t caller) {
  const std::lock_guard lock(mutex_);
  left_[caller] = true;
  changed_.notify_all();
}

bool BatchEvaluator::all_have_asked_or_left() const {
  for (std::size_t i = 0; i < left_.size(); ++i)
    if (!left_[i] && !questions_[i]) return false;
  return true;
}

void BatchEvaluator::serve(const Compute& compute) {
  std::exception_ptr failure;
  for (;;) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return all_have_asked_or_left(); });
    std::vector<std::size_t> callers;
    std::vector<Configuration> piercings;
    for (std::size_t i = 0; i < questions_.size(); ++i) {
      if (!questions_[i]) continue;
      callers.push_back(i);
      piercings.push_back(std::move(*questions_[i]));
      questions_[i].reset();
    }
    if (callers.empty()) break;
    lock.unlock();
    std::vector<nlohmann::json> results(piercings.size());
    try {
      if (!failure) results = compute(piercings);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    for (std::size_t i = 0; i < callers.size(); ++i) answers_[callers[i]] = std::move(results[i]);
    changed_.notify_all();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace zona::studies::search
