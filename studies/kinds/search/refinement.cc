#include "studies/kinds/search/refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <nlopt.hpp>
#include <thread>

#include "studies/kinds/search/merit.h"
#include "studies/kinds/search/rendezvous.h"
#include "studies/run/interrupt.h"

namespace zona::studies::search {

namespace {

/// First steps and smallest ones, in ranges.
constexpr double kFirstStep = 0.12, kLastStep = 0.01;
/// Designs that leave limits of the tip cost a beam only; of those that many per piercing.
constexpr long kMostBeams = 20;
/// What leaving a limit by its own size costs, in what the reference comes to.
constexpr double kPenalty = 10;
/// More than what is worth keeping; finite, because the optimiser lays planes through its values.
constexpr double kLeavesTip = 10, kImpossible = 100;

/// The way from one start.
class Way {
 public:
  Way(const Plan& plan, std::size_t number, const Design& start, const Values& reference,
      Rendezvous& rendezvous)
      : plan_(plan),
        number_(number),
        combination_(combinations(plan.variables)[start.combination]),
        start_(start),
        reference_(reference),
        rendezvous_(rendezvous),
        meter_(plan, {}) {}

  void go() {
    std::vector<double> place = start_.place;
    nlopt::opt optimiser(nlopt::LN_COBYLA, static_cast<unsigned>(place.size()));
    const nlopt::vfunc cost = [](const std::vector<double>& x, std::vector<double>&, void* way) {
      return static_cast<Way*>(way)->cost_at(x);
    };
    optimiser.set_min_objective(cost, this);
    optimiser.set_lower_bounds(0);
    optimiser.set_upper_bounds(1);
    optimiser.set_initial_step(kFirstStep);
    optimiser.set_xtol_abs(kLastStep);
    optimiser.set_maxeval(static_cast<int>(kMostBeams * static_cast<long>(plan_.refinements)));
    double least = 0;
    try {
      optimiser.optimize(place, least);
    } catch (const nlopt::forced_stop&) {
    } catch (const nlopt::roundoff_limited&) {  // it has come as far as it can
    }
  }

  const std::vector<Trial>& trials() const { return trials_; }

 private:
  double cost_at(const std::vector<double>& place) {
    if (Interrupt::requested() || trials_.size() == plan_.refinements) throw nlopt::forced_stop();
    const Settings settings = settings_at(plan_.variables, combination_, place);
    for (const Trial& trial : trials_)
      if (trial.design.settings == settings) return trial.cost;
    const auto tip = meter_.measure(settings);
    if (!tip) return kImpossible;
    const double off = excess(plan_.limits_of(Measure::Of::tip), *tip);
    if (off > 0) return std::min(kLeavesTip + kPenalty * off, kImpossible);
    const nlohmann::json piercing = rendezvous_.ask(number_, plan_.study(settings));
    if (piercing.is_null()) throw nlopt::forced_stop();
    Trial trial{
        number_, {start_.combination, place, settings, *tip}, all_values(*tip, piercing), 0};
    trial.cost = cost_of(trial.values);
    trials_.push_back(trial);
    return trial.cost;
  }

  double cost_of(const Values& values) const {
    std::vector<double> ratios;
    for (const Measure* objective : plan_.objectives) {
      const auto found = values.find(objective->name);
      if (found == values.end()) return kImpossible;
      const auto known = reference_.find(objective->name);
      const bool counts = known != reference_.end() && known->second > 0;
      ratios.push_back(found->second / (counts ? known->second : 1));
    }
    return std::min(worst_of(ratios) + kPenalty * excess(plan_.limits, values), kImpossible);
  }

  const Plan& plan_;
  std::size_t number_;
  std::vector<std::size_t> combination_;
  const Design& start_;
  const Values& reference_;
  Rendezvous& rendezvous_;
  TipMeter meter_;
  std::vector<Trial> trials_;
};

}  // namespace

Values all_values(const Values& tip, const nlohmann::json& piercing) {
  Values values = tip;
  for (const std::string& name : measure_names(Measure::Of::oocyte))
    if (piercing.contains(name) && piercing[name].is_number())
      values[name] = piercing[name].get<double>();
  return values;
}

std::vector<Trial> refine(const Plan& plan, const std::vector<Design>& starts,
                          const Values& reference, const CaseStore& store, Session& session) {
  Rendezvous rendezvous(starts.size());
  std::vector<std::unique_ptr<Way>> ways;
  for (std::size_t i = 0; i < starts.size(); ++i)
    ways.push_back(std::make_unique<Way>(plan, i, starts[i], reference, rendezvous));
  std::vector<std::exception_ptr> failures(starts.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < starts.size(); ++i)
    threads.emplace_back([&, i] {
      try {
        ways[i]->go();
      } catch (...) {
        failures[i] = std::current_exception();
      }
      rendezvous.leave(i);
    });
  std::exception_ptr failure;
  int round = 0;
  try {
    rendezvous.serve([&](const std::vector<Configuration>& piercings) {
      return store.run(piercings, fmt::format("refinement, round {}", ++round), session);
    });
  } catch (...) {
    failure = std::current_exception();
  }
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (failures[i]) std::rethrow_exception(failures[i]);
    trials.insert(trials.end(), ways[i]->trials().begin(), ways[i]->trials().end());
  }
  return trials;
}

}  // namespace zona::studies::search
