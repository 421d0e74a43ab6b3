#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace zona::studies {

class Progress;
class RunDirectory;

/// Surroundings of a study while it runs.
struct Session {
  RunDirectory& directory;   ///< where its files and its log go
  Progress& progress;        ///< shown to the user
  nlohmann::json& results;   ///< becomes "results" of summary.json; SI units
  int threads = 1;           ///< already set for OpenMP
  bool resume = false;       ///< continue from the checkpoints in the directory
  std::string conclusion{};  ///< text for standard output at the end
};

}  // namespace zona::studies
