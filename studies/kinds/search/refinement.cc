#include "studies/kinds/search/refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "studies/kinds/search/batch_evaluator.h"
#include "studies/kinds/search/cost.h"
#include "studies/kinds/search/minimise.h"
#include "studies/run/interrupt.h"
#include "studies/run/parallel.h"

namespace zona::studies::search {

namespace {

/// First and smallest steps, as fractions of the ranges.
constexpr double first_step = 0.12, last_step = 0.01;
/// Most beams per piercing: designs that violate limits of the tip take a beam only.
constexpr long most_beams = 20;
/// Penalty per 100 % violation, in units of the reference value.
constexpr double penalty = 10;
/// Costs of designs that violate limits of the tip, and of impossible ones. Greater than any cost
/// worth keeping, but finite, because the optimiser fits planes to its values.
constexpr double tip_violated = 10, impossible = 100;

/// The search from one start.
class LocalSearch {
 public:
  LocalSearch(const Plan& plan, std::size_t number, const Design& start, const Values& reference,
              BatchEvaluator& evaluator)
      : plan_(plan),
        number_(number),
        combination_(combinations(plan.variables)[start.combination]),
        start_(start),
        reference_(reference),
        evaluator_(evaluator),
        meter_(plan, {}) {}

  void run() {
    minimise(nlopt::LN_COBYLA, start_.place,
             {first_step, last_step, most_beams * static_cast<long>(plan_.refinements)},
             [&](const std::vector<double>& place) { return cost_at(place); });
  }

  const std::vector<Evaluation>& evaluations() const { return evaluations_; }

 private:
  double cost_at(const std::vector<double>& place) {
    if (Interrupt::requested() || evaluations_.size() == plan_.refinements)
      throw nlopt::forced_stop();
    const Overrides overrides = overrides_at(plan_.variables, combination_, place);
    for (const Evaluation& evaluation : evaluations_)
      if (evaluation.design.overrides == overrides) return evaluation.cost;
    const auto tip = meter_.measure(overrides);
    if (!tip) return impossible;
    const double violation = excess(plan_.limits_of(Measure::Of::tip), *tip);
    if (violation > 0) return std::min(tip_violated + penalty * violation, impossible);
    const nlohmann::json piercing = evaluator_.evaluate(number_, plan_.study(overrides));
    if (piercing.is_null()) throw nlopt::forced_stop();
    Evaluation evaluation{
        number_, {start_.combination, place, overrides, *tip}, all_values(*tip, piercing), 0};
    evaluation.cost = cost_of(evaluation.values);
    evaluations_.push_back(evaluation);
    return evaluation.cost;
  }

  double cost_of(const Values& values) const {
    std::vector<double> ratios;
    for (const Measure* objective : plan_.objectives) {
      const auto found = values.find(objective->name);
      if (found == values.end()) return impossible;
      const auto known = reference_.find(objective->name);
      const bool counts = known != reference_.end() && known->second > 0;
      ratios.push_back(found->second / (counts ? known->second : 1));
    }
    return std::min(worst_of(ratios) + penalty * excess(plan_.limits, values), impossible);
  }

  const Plan& plan_;
  std::size_t number_;
  std::vector<std::size_t> combination_;
  const Design& start_;
  const Values& reference_;
  BatchEvaluator& evaluator_;
  TipMeter meter_;
  std::vector<Evaluation> evaluations_;
};

/// Lets a caller leave at the end of a scope, also after an error.
class Leaving {
 public:
  Leaving(BatchEvaluator& evaluator, std::size_t caller) : evaluator_(evaluator), caller_(caller) {}
  ~Leaving() { evaluator_.leave(caller_); }
  Leaving(const Leaving&) = delete;
  Leaving& operator=(const Leaving&) = delete;

 private:
  BatchEvaluator& evaluator_;
  std::size_t caller_;
};

}  // namespace

Values all_values(const Values& tip, const nlohmann::json& piercing) {
  Values values = tip;
  for (const std::string& name : measure_names(Measure::Of::oocyte))
    if (piercing.contains(name) && piercing[name].is_number())
      values[name] = piercing[name].get<double>();
  return values;
}

std::vector<Evaluation> refine(const Plan& plan, const std::vector<Design>& starts,
                               const Values& reference, const CaseStore& store, Session& session) {
  const std::size_t count = starts.size();
  BatchEvaluator evaluator(count);
  std::vector<std::unique_ptr<LocalSearch>> searches;
  for (std::size_t i = 0; i < count; ++i)
    searches.push_back(std::make_unique<LocalSearch>(plan, i, starts[i], reference, evaluator));
  // All at a time: the evaluator waits for each of them.
  ParallelLoop loop(count, {static_cast<int>(count), 1}, [&](std::size_t i) {
    const Leaving leaving(evaluator, i);
    searches[i]->run();
  });
  int round = 0;
  evaluator.serve([&](const std::vector<Configuration>& piercings) {
    return store.run(piercings, fmt::format("refinement, round {}", ++round), session);
  });
  loop.join();
  loop.rethrow();
  std::vector<Evaluation> evaluations;
  for (const auto& search : searches)
    evaluations.insert(evaluations.end(), search->evaluations().begin(),
                       search->evaluations().end());
  return evaluations;
}

}  // namespace zona::studies::search
