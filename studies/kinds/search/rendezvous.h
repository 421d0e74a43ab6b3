#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "studies/input/configuration.h"

namespace zona::studies::search {

/// Where callers that each want one result after another, each in a thread of its own, meet
/// somebody who computes many at once. He waits until every caller has asked or left, so that what
/// a caller is told depends on nothing but what it asks.
class Rendezvous {
 public:
  explicit Rendezvous(std::size_t callers)
      : questions_(callers), answers_(callers), left_(callers) {}

  /// The result of a piercing, to the caller of this number; null when there will be none.
  nlohmann::json ask(std::size_t caller, const Configuration& piercing);
  /// The caller asks no more.
  void leave(std::size_t caller);

  using Compute =
      std::function<std::vector<nlohmann::json>(const std::vector<Configuration>& piercings)>;
  /// Answers until all have left. An error of `compute` passes on when they have; until then all
  /// are told null.
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
