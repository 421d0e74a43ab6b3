#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studies/input/table_keys.h"
#include "studies/kinds/search/measure.h"

namespace zona::studies::search {

/// Base study, objectives and effort of the search.
struct SearchTable {
  std::filesystem::path study_file;            ///< of the piercing that is varied
  std::vector<const Measure*> tip_objectives;  ///< choose designs by their beams
  std::vector<const Measure*> objectives;      ///< rank the piercings
  std::size_t samples;      ///< designs of the hypercube, per combination of listed values
  long evaluations;         ///< of the optimiser, per combination and weighting
  int divisions;            ///< of the simplex of weightings
  std::size_t candidates;   ///< designs that pierce
  std::size_t refinements;  ///< piercings of the optimiser, for each design that it starts from
  /// Candidates that pierce with every sample of the uncertain inputs; empty: all.
  std::optional<std::size_t> finalists;
  std::size_t uncertainty_samples;
  double confidence;               ///< share of samples in which the limits must hold
  bool derivatives;                ///< by re-runs at the ends of the uncertain inputs
  std::vector<std::string> avoid;  ///< fluids that an answer must do without
  std::uint64_t seed;              ///< of the hypercubes

  std::size_t finalist_count() const { return finalists.value_or(candidates); }
};

/// The section [search]. Complains of more finalists than candidates.
void declare_search(Schema& schema);

}  // namespace zona::studies::search
