#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "studies/input/configuration.h"

namespace zona::studies::search {

/// Computes piercings in batches for callers in threads of their own, each of which needs one
/// result after another. A batch begins when every caller has asked or left, so that the batches do
/// not depend on the timing of threads.
class BatchEvaluator {
 public:
  explicit BatchEvaluator(std::size_t callers)
      : questions_(callers), answers_(callers), left_(callers) {}

  /// The result of a piercing for a caller, from 0; waits for it. Null when there will be none.
  nlohmann::json evaluate(std::size_t caller, const Configuration& piercing);
  /// The caller needs no more results.
  void leave(std::size_t caller);

  using Compute =
      std::function<std::vector<nlohmann::json>(const std::vector<Configuration>& piercings)>;
  /// Computes batches until all callers have left. After an error of `compute` all callers get
  /// null; it is thrown when they have left.
  void serve(const Compute& compute);

 private:
  bool all_have_asked_or_left() const;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::optional<Configuration>> questions_;
  std::vector<std::optional<nlohmann::json>> answers_;
  std::vector<bool> left_;
};

}  // namespace zona::studies::search
