#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/kinds/search/measure.h"
#include "studies/kinds/search/search_table.h"
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
struct Plan : SearchTable {
  Configuration base;  ///< the study that is varied; as it stands, the reference
  std::vector<Dimension> variables;
  std::vector<Dimension> uncertain;
  std::vector<Limit> limits;

  std::vector<Limit> limits_of(Measure::Of of) const;
  /// The base with these overrides. Throws InputError where they contradict each other.
  Configuration study(const Overrides& overrides) const;
};

/// The piercing study that a search varies. Throws InputError for a study of another kind.
Configuration load_reference(const std::filesystem::path& file, const Overrides& overrides = {});

/// The plan of a search, with the study that it varies. Throws InputError.
Plan plan_from(const Configuration& search);

}  // namespace zona::studies::search
