#include "studies/kinds/search/tip_stage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "studies/kinds/search/cost.h"
#include "studies/kinds/search/minimise.h"
#include "studies/kinds/search/pareto.h"
#include "studies/run/interrupt.h"
#include "studies/run/parallel.h"

namespace zona::studies::search {

namespace {

/// Weight of an objective that a weighting leaves out.
constexpr double least_weight = 0.01;
/// Penalty per 100 % violation of a limit, in ranges of an objective.
constexpr double limit_penalty = 100;

std::vector<double> objectives_of(const Plan& plan, const Values& values) {
  std::vector<double> point;
  for (const Measure* measure : plan.tip_objectives) point.push_back(values.at(measure->name));
  return point;
}

/// Least value and range of each objective, by which weightings compare them.
struct ObjectiveScale {
  std::vector<double> least, range;
};

ObjectiveScale scale_of(const Plan& plan, const std::vector<Design>& designs) {
  ObjectiveScale scale;
  for (const Measure* measure : plan.tip_objectives) {
    std::vector<double> values;
    for (const Design& design : designs) values.push_back(design.tip.at(measure->name));
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    scale.least.push_back(*least);
    scale.range.push_back(*most > *least ? *most - *least : 1);
  }
  return scale;
}

/// Explores one combination of listed values.
class Explorer {
 public:
  Explorer(const Plan& plan, std::size_t number, std::vector<std::size_t> choice)
      : plan_(plan), number_(number), choice_(std::move(choice)), meter_(plan, {}) {
    for (const Dimension& variable : plan_.variables) ranges_ += variable.is_list() ? 0 : 1;
  }

  void sample() {
    if (ranges_ == 0) {
      try_design({});
      return;
    }
    for (const auto& place : latin_hypercube(ranges_, plan_.samples, plan_.seed + number_)) {
      if (Interrupt::requested()) return;
      try_design(place);
    }
  }

  void optimise(const ObjectiveScale& scale) {
    if (ranges_ == 0 || plan_.evaluations == 0 || designs_.empty()) return;
    for (const auto& weights : simplex_lattice(plan_.tip_objectives.size(), plan_.divisions)) {
      if (Interrupt::requested()) return;
      const auto cost = [&](const Values& values) {
        std::vector<double> point = objectives_of(plan_, values);
        for (std::size_t k = 0; k < point.size(); ++k)
          point[k] =
              std::max(weights[k], least_weight) * (point[k] - scale.least[k]) / scale.range[k];
        return worst_of(point) + limit_penalty * excess(plan_.limits_of(Measure::Of::tip), values);
      };
      minimise(cost);
    }
  }

  const std::vector<Design>& designs() const { return designs_; }
  std::size_t impossible() const { return impossible_; }
  const Values& reference() const { return meter_.reference(); }

 private:
  /// The measures; nothing for an impossible design.
  std::optional<Values> try_design(const std::vector<double>& place) {
    const Overrides overrides = overrides_at(plan_.variables, choice_, place);
    const auto known = tried_.find(overrides);
    if (known != tried_.end()) return known->second;
    const std::optional<Values> values = meter_.measure(overrides);
    tried_[overrides] = values;
    if (values) {
      designs_.push_back({number_, place, overrides, *values});
    } else {
      ++impossible_;
    }
    return values;
  }

  template <class Cost>
  void minimise(const Cost& cost) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < designs_.size(); ++i)
      if (cost(designs_[i].tip) < cost(designs_[best].tip)) best = i;
    search::minimise(nlopt::LN_SBPLX, designs_[best].place, {0.1, 1e-3, plan_.evaluations},
                     [&](const std::vector<double>& place) {
                       if (Interrupt::requested()) throw nlopt::forced_stop();
                       const std::optional<Values> values = try_design(place);
                       return values ? cost(*values) : HUGE_VAL;
                     });
  }

  const Plan& plan_;
  std::size_t number_;
  std::vector<std::size_t> choice_;
  TipMeter meter_;
  std::size_t ranges_ = 0;
  std::map<Overrides, std::optional<Values>> tried_;
  std::vector<Design> designs_;
  std::size_t impossible_ = 0;
};

}  // namespace

TipStage explore(const Plan& plan, Session& session) {
  std::vector<std::unique_ptr<Explorer>> explorers;
  const auto choices = combinations(plan.variables);
  for (std::size_t i = 0; i < choices.size(); ++i)
    explorers.push_back(std::make_unique<Explorer>(plan, i, choices[i]));
  const auto for_all = [&](const std::string& label, const auto& action) {
    parallel_stage(label, explorers.size(), session.threads, session.progress, [&](std::size_t i) {
      action(*explorers[i]);
      return std::string();
    });
  };
  for_all("beams: hypercube", [](Explorer& explorer) { explorer.sample(); });
  std::vector<Design> sampled;
  for (const auto& explorer : explorers)
    sampled.insert(sampled.end(), explorer->designs().begin(), explorer->designs().end());
  if (!sampled.empty()) {
    const ObjectiveScale scale = scale_of(plan, sampled);
    for_all("beams: optimiser", [&](Explorer& explorer) { explorer.optimise(scale); });
  }
  TipStage stage;
  for (const auto& explorer : explorers) {
    stage.reference = explorer->reference();
    stage.impossible += explorer->impossible();
    stage.designs.insert(stage.designs.end(), explorer->designs().begin(),
                         explorer->designs().end());
  }
  return stage;
}

std::vector<std::size_t> choose_candidates(const Plan& plan, const TipStage& stage) {
  const std::vector<Limit> limits = plan.limits_of(Measure::Of::tip);
  const std::size_t combination_count = combinations(plan.variables).size();
  std::vector<std::size_t> chosen;
  for (std::size_t c = 0; c < combination_count; ++c) {
    std::vector<std::size_t> numbers;
    std::vector<std::vector<double>> points;
    for (std::size_t i = 0; i < stage.designs.size(); ++i) {
      if (stage.designs[i].combination != c || excess(limits, stage.designs[i].tip) > 0) continue;
      numbers.push_back(i);
      points.push_back(objectives_of(plan, stage.designs[i].tip));
    }
    std::vector<std::size_t> front = pareto_front(points);
    std::vector<std::vector<double>> front_points;
    for (const std::size_t i : front) front_points.push_back(points[i]);
    // The remainder goes to the first combinations.
    const std::size_t share =
        plan.candidates / combination_count + (c < plan.candidates % combination_count ? 1 : 0);
    for (const std::size_t i : spread(front_points, share)) chosen.push_back(numbers[front[i]]);
  }
  return chosen;
}

}  // namespace zona::studies::search
