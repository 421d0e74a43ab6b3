#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/kinds/search/measure.h"
#include "studies/kinds/search/space.h"

namespace zona::studies::search {

/// Limits of a measure, in SI.
struct Limit {
  const Measure* measure;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  bool holds(double value) const { return value >= least && value <= most; }
  /// Distance of the value from the limit over the limit; 0 where it holds.
  double excess(double value) const;
  std::string text() const;
};

/// A search study.
struct Plan {
  Configuration base;  ///< the study that is varied; as it stands, the reference
  std::vector<Dimension> variables;
  std::vector<Dimension> uncertain;
  std::vector<const Measure*> tip_objectives;  ///< choose designs by their beams
  std::vector<const Measure*> objectives;      ///< rank the piercings
  std::vector<Limit> limits;
  std::size_t samples;      ///< designs of the hypercube, per combination of listed values
  long evaluations;         ///< of the optimiser, per combination and weighting
  int divisions;            ///< of the simplex of weightings
  std::size_t candidates;   ///< designs that pierce
  std::size_t refinements;  ///< piercings of the optimiser, for each design that it starts from
  std::size_t finalists;    ///< of these, that pierce with every sample of the uncertain inputs
  std::size_t uncertainty_samples;
  double confidence;               ///< share of samples in which the limits must hold
  bool derivatives;                ///< by re-runs at the ends of the uncertain inputs
  std::vector<std::string> avoid;  ///< fluids that an answer must do without
  std::uint64_t seed;

  std::vector<Limit> limits_of(Measure::Of of) const;
  /// The base with these overrides. Throws InputError where they contradict each other.
  Configuration study(const Overrides& overrides) const;
};

/// The piercing study that a search varies. Throws InputError for a study of another kind.
Configuration load_reference(const std::filesystem::path& file, const Overrides& overrides = {});

/// The plan of a search, with the study that it varies. Throws InputError.
Plan plan_from(const Configuration& search);

}  // namespace zona::studies::search
