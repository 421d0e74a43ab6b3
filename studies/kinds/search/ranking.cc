#include "studies/kinds/search/ranking.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "studies/kinds/search/pareto.h"

namespace zona::studies::search {

namespace {

constexpr double low_share = 0.05, high_share = 0.95;

double value_of(const Values& values, const std::string& measure) {
  const auto found = values.find(measure);
  return found == values.end() ? std::numeric_limits<double>::infinity() : found->second;
}

/// A measure in every sample; empty where it is unknown in one.
std::vector<double> over_samples(const Candidate& candidate, const std::string& measure) {
  std::vector<double> values;
  for (const Values& sample : candidate.samples) {
    const auto found = sample.find(measure);
    if (found == sample.end()) return {};
    values.push_back(found->second);
  }
  return values;
}

std::vector<std::size_t> sorted_by(const std::vector<std::tuple<bool, int, double>>& merits) {
  std::vector<std::size_t> order(merits.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return merits[a] < merits[b]; });
  return order;
}

}  // namespace

bool keeps(const std::vector<Limit>& limits, const Values& values) {
  return std::all_of(limits.begin(), limits.end(), [&](const Limit& limit) {
    const auto found = values.find(limit.measure->name);
    return found != values.end() && limit.holds(found->second);
  });
}

std::vector<std::size_t> nominal_order(const Plan& plan, const std::vector<Candidate>& candidates) {
  std::vector<std::vector<double>> points;
  for (const Candidate& candidate : candidates) {
    points.emplace_back();
    for (const Measure* objective : plan.objectives)
      points.back().push_back(value_of(candidate.nominal, objective->name));
  }
  const std::vector<int> levels = pareto_levels(points);
  std::vector<std::tuple<bool, int, double>> merits;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    merits.emplace_back(!keeps(plan.limits_of(Measure::Of::oocyte), candidates[i].nominal),
                        levels[i], points[i].front());
  return sorted_by(merits);
}

std::vector<Verdict> judge(const Plan& plan, const Candidate& reference,
                           const std::vector<Candidate>& finalists) {
  const std::vector<Limit> limits = plan.limits_of(Measure::Of::oocyte);
  std::vector<Verdict> verdicts;
  std::vector<std::vector<double>> points;
  for (const Candidate& finalist : finalists) {
    Verdict verdict;
    for (const Measure& measure : measures()) {
      const std::vector<double> values = over_samples(finalist, measure.name);
      const std::vector<double> others = over_samples(reference, measure.name);
      if (values.empty()) continue;
      double better = 0;
      for (std::size_t i = 0; i < std::min(values.size(), others.size()); ++i)
        if (values[i] < others[i]) ++better;
      verdict.measures[measure.name] = {quantile(values, 0.5), quantile(values, low_share),
                                        quantile(values, high_share),
                                        better / static_cast<double>(values.size())};
    }
    const auto kept = std::count_if(finalist.samples.begin(), finalist.samples.end(),
                                    [&](const Values& values) { return keeps(limits, values); });
    verdict.keeps_limits = static_cast<double>(kept) / static_cast<double>(finalist.samples.size());
    const auto first = verdict.measures.find(plan.objectives.front()->name);
    verdict.is_answer = finalist.is_free && verdict.keeps_limits >= plan.confidence &&
                        first != verdict.measures.end() && first->second.better >= plan.confidence;
    points.emplace_back();
    for (const Measure* objective : plan.objectives) {
      const auto found = verdict.measures.find(objective->name);
      points.back().push_back(found == verdict.measures.end()
                                  ? std::numeric_limits<double>::infinity()
                                  : found->second.median);
    }
    verdicts.push_back(std::move(verdict));
  }
  const std::vector<int> levels = pareto_levels(points);
  for (std::size_t i = 0; i < verdicts.size(); ++i) verdicts[i].level = levels[i];
  return verdicts;
}

std::vector<std::size_t> final_order(const Plan& plan, const std::vector<Verdict>& verdicts) {
  std::vector<std::tuple<bool, int, double>> merits;
  for (const Verdict& verdict : verdicts) {
    const auto found = verdict.measures.find(plan.objectives.front()->name);
    merits.emplace_back(verdict.keeps_limits < plan.confidence, verdict.level,
                        found == verdict.measures.end() ? std::numeric_limits<double>::infinity()
                                                        : found->second.median);
  }
  return sorted_by(merits);
}

double mean_correlation(const std::vector<double>& input,
                        const std::vector<const Candidate*>& subjects, const std::string& measure) {
  double sum = 0;
  int count = 0;
  for (const Candidate* subject : subjects) {
    const std::vector<double> values = over_samples(*subject, measure);
    if (values.size() != input.size()) continue;
    sum += rank_correlation(input, values);
    ++count;
  }
  return count == 0 ? 0 : sum / count;
}

}  // namespace zona::studies::search
