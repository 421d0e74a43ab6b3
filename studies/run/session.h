#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace zona::studies {

class Progress;
class RunDirectory;

/// What a study works with while it runs, besides its configuration.
struct Session {
  RunDirectory& directory;   ///< where its files and its log go
  Progress& progress;        ///< tells the user how far it is
  nlohmann::json& results;   ///< becomes "results" of summary.json; SI units
  int threads = 1;           ///< already set for OpenMP
  bool resume = false;       ///< go on from the checkpoints in the directory
  std::string conclusion{};  ///< what the user reads at the end, on standard output
};

}  // namespace zona::studies
