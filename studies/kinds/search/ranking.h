#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "studies/kinds/search/plan.h"
#include "studies/kinds/search/tip_stage.h"

namespace zona::studies::search {

/// A design that pierces, or the reference.
struct Candidate {
  std::string label;    ///< "FC-40 2"; "reference"
  Overrides overrides;  ///< of the base
  bool is_free;         ///< of the fluids to be avoided
  std::string folder;   ///< of its piercing with the base's inputs
  Values nominal;       ///< with the base's inputs; without oocyte's measures where it failed
  std::vector<std::string> warnings{};  ///< where the bath's load is taken too far
  std::vector<Values> samples{};  ///< with each sample of the uncertain inputs; empty: no finalist
};

/// A measure over the samples.
struct Spread {
  double median, low, high;  ///< low and high: 5 and 95 % of the samples
  double better;             ///< share of the samples in which it is less than the reference's
};

/// Judgement of a candidate by its samples.
struct Verdict {
  std::map<std::string, Spread> measures;  ///< of all that are known in every sample
  double keeps_limits = 0;                 ///< share of the samples
  int level = 0;                           ///< fronts before its own, among all ranked
  /// Free of what is to be avoided, within the limits and better than the reference in the first
  /// objective, both in the share of samples that the search asks for.
  bool is_answer = false;
};

/// Every limit holds and every measure is known.
bool keeps(const std::vector<Limit>& limits, const Values& values);

/// Candidates by their nominal values, the best first: those within the limits, by front, then by
/// the first objective.
std::vector<std::size_t> nominal_order(const Plan& plan, const std::vector<Candidate>& candidates);

/// Verdicts on all finalists, in their order; the reference must have samples, too.
std::vector<Verdict> judge(const Plan& plan, const Candidate& reference,
                           const std::vector<Candidate>& finalists);

/// Numbers of the finalists, the best first: those that keep to the limits, by front, then by the
/// median of the first objective.
std::vector<std::size_t> final_order(const Plan& plan, const std::vector<Verdict>& verdicts);

/// Mean over the subjects of Spearman's correlation of an input over the samples with a measure.
double mean_correlation(const std::vector<double>& input,
                        const std::vector<const Candidate*>& subjects, const std::string& measure);

}  // namespace zona::studies::search
