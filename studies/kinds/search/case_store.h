#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/run/session.h"

namespace zona::studies::search {

/// Results of piercings in a folder, each in one of its own that is named by what decides it
/// (`study_fingerprint` and the program's version): study.toml, which `zona run` takes as it is,
/// history.csv, tip.csv, results.json and, as long as it is not complete, checkpoints. Several
/// processes may work on one store.
class CaseStore {
 public:
  explicit CaseStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_of(const Configuration& piercing) const;
  /// Null when it has not been computed.
  nlohmann::json result(const Configuration& piercing) const;

  /// Runs those that have no result, as many side by side as the session has threads, each from
  /// its last checkpoint; results in the order of the piercings. One that another process computes
  /// is waited for. After an interrupt, null for what is not complete. A piercing whose points go
  /// wrong has `failure` as its result, a text. Throws RunError when files cannot be written.
  std::vector<nlohmann::json> run(const std::vector<Configuration>& piercings,
                                  const std::string& label, Session& session) const;

 private:
  enum class State { complete, interrupted, busy };

  State compute(const Configuration& piercing, int threads, int part, Session& session) const;

  std::filesystem::path folder_;
};

}  // namespace zona::studies::search
