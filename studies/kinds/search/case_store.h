#pragma once

#include <deque>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/run/session.h"

namespace zona::studies::search {

/// Results of piercings. Each piercing has a folder, named by its `study_fingerprint` and the
/// program's version, with study.toml, which `zona run` takes, history.csv, tip.csv, results.json
/// and, until it is complete, checkpoints. Several processes may work on one store.
class CaseStore {
 public:
  explicit CaseStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_of(const Configuration& piercing) const;
  /// Null when there is none yet.
  nlohmann::json result(const Configuration& piercing) const;

  /// Runs the piercings that have no result, as many side by side as the session has threads, each
  /// from its last checkpoint, and waits for those that another process computes. Returns results
  /// in the order of the piercings; after an interrupt null for what is not complete. A piercing
  /// whose points fail has the text `failure` in its result. Throws RunError when files cannot be
  /// written.
  std::vector<nlohmann::json> run(const std::vector<Configuration>& piercings,
                                  const std::string& label, Session& session) const;

 private:
  enum class State { complete, interrupted, busy };

  State compute(const Configuration& piercing, int threads, int part, Session& session) const;
  /// Takes the results that exist, as parts of a stage that are done at `longest`; returns the
  /// numbers of the others.
  std::deque<std::size_t> look_up(const std::vector<Configuration>& piercings, double longest,
                                  Progress& progress, std::vector<nlohmann::json>& results) const;

  std::filesystem::path folder_;
};

}  // namespace zona::studies::search
