#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/kinds/search/ranking.h"
#include "studies/kinds/search/refinement.h"

namespace zona::studies::search {

/// The uncertain inputs of one sample.
struct Sample {
  Overrides overrides;
  std::vector<double> values;  ///< in the units of the inputs; the number of a listed value
};

/// Measures with an uncertain input at an end of its range.
struct End {
  std::size_t input = 0;
  bool is_high = false;
  std::string subject;  ///< label of the design
  Values values;
};

/// Results of a search, stage by stage.
struct Record {
  Plan plan;
  std::vector<Sample> samples{};
  TipStage tips{};
  double tip_seconds = 0;  ///< wall time of the beams
  Candidate reference{};
  std::vector<Candidate> candidates{};
  std::vector<Evaluation> evaluations{};  ///< of the second optimiser
  std::vector<std::size_t> finalists{};   ///< numbers of candidates, the best first
  std::vector<Verdict> verdicts{};        ///< of the finalists
  std::optional<Verdict> reference_verdict{};
  std::vector<End> ends{};
};

}  // namespace zona::studies::search
