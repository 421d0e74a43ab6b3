#include "studies/kinds/search/tip_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>
#include <set>

#include "beam/frequency/transfer_function.h"
#include "studies/kinds/search/merit.h"
#include "studies/kinds/search/pareto.h"
#include "studies/parameters/beam_parameters.h"
#include "studies/parameters/shared_parameters.h"
#include "studies/run/interrupt.h"
#include "studies/run/progress.h"

namespace zona::studies::search {

namespace {

constexpr int kWindowSamples = 400;

/// Weight of an objective that a weighting leaves out.
constexpr double kLeastWeight = 0.01;
/// What leaving a limit by its own size costs, in ranges of an objective.
constexpr double kPenalty = 100;

bool starts_with(const std::string& text, const char* beginning) {
  return text.rfind(beginning, 0) == 0;
}

/// The settings that decide the transfer function.
std::string pipette_part(const Settings& settings) {
  std::string part;
  for (const std::string& setting : settings)
    if (!starts_with(setting, "pulse.") && !starts_with(setting, "motion.") &&
        !starts_with(setting, "zona."))
      part += setting + "\n";
  return part;
}

std::vector<double> objectives_of(const Plan& plan, const Values& values) {
  std::vector<double> point;
  for (const Measure* measure : plan.tip_objectives) point.push_back(values.at(measure->name));
  return point;
}

/// Of each objective the least value and the range, by which weightings compare them.
struct Scale {
  std::vector<double> least, range;
};

Scale scale_of(const Plan& plan, const std::vector<Design>& designs) {
  Scale scale;
  for (const Measure* measure : plan.tip_objectives) {
    std::vector<double> values;
    for (const Design& design : designs) values.push_back(design.tip.at(measure->name));
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    scale.least.push_back(*least);
    scale.range.push_back(*most > *least ? *most - *least : 1);
  }
  return scale;
}

/// One combination of listed values, with all its designs.
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

  void optimise(const Scale& scale) {
    if (ranges_ == 0 || plan_.evaluations == 0 || designs_.empty()) return;
    for (const auto& weights : simplex_lattice(plan_.tip_objectives.size(), plan_.divisions)) {
      if (Interrupt::requested()) return;
      const auto cost = [&](const Values& values) {
        std::vector<double> point = objectives_of(plan_, values);
        for (std::size_t k = 0; k < point.size(); ++k)
          point[k] =
              std::max(weights[k], kLeastWeight) * (point[k] - scale.least[k]) / scale.range[k];
        return worst_of(point) + kPenalty * excess(plan_.limits_of(Measure::Of::tip), values);
      };
      minimise(cost);
    }
  }

  const std::vector<Design>& designs() const { return designs_; }
  std::size_t impossible() const { return impossible_; }
  const Values& reference() const { return meter_.reference(); }

 private:
  /// The measures; nothing for a design that cannot be.
  std::optional<Values> try_design(const std::vector<double>& place) {
    const Settings settings = settings_at(plan_.variables, choice_, place);
    const auto known = tried_.find(settings);
    if (known != tried_.end()) return known->second;
    const std::optional<Values> values = meter_.measure(settings);
    tried_[settings] = values;
    if (values) {
      designs_.push_back({number_, place, settings, *values});
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
    std::vector<double> place = designs_[best].place;
    nlopt::opt optimiser(nlopt::LN_SBPLX, static_cast<unsigned>(ranges_));
    const nlopt::vfunc objective = [](const std::vector<double>& x, std::vector<double>&,
                                      void* data) {
      const auto& [explorer, how] = *static_cast<std::pair<Explorer*, const Cost*>*>(data);
      if (Interrupt::requested()) throw nlopt::forced_stop();
      const std::optional<Values> values = explorer->try_design(x);
      return values ? (*how)(*values) : HUGE_VAL;
    };
    std::pair<Explorer*, const Cost*> context(this, &cost);
    optimiser.set_min_objective(objective, &context);
    optimiser.set_lower_bounds(0);
    optimiser.set_upper_bounds(1);
    optimiser.set_initial_step(0.1);
    optimiser.set_xtol_abs(1e-3);
    optimiser.set_maxeval(static_cast<int>(plan_.evaluations));
    double least = 0;
    try {
      optimiser.optimize(place, least);
    } catch (const nlopt::forced_stop&) {
    } catch (const nlopt::roundoff_limited&) {  // it has come as far as it can
    }
  }

  const Plan& plan_;
  std::size_t number_;
  std::vector<std::size_t> choice_;
  TipMeter meter_;
  std::size_t ranges_ = 0;
  std::map<Settings, std::optional<Values>> tried_;
  std::vector<Design> designs_;
  std::size_t impossible_ = 0;
};

/// Calls `action` for all explorers in parallel; an error of the first that has one passes on.
template <class Action>
void for_all(std::vector<std::unique_ptr<Explorer>>& explorers, const std::string& label,
             Session& session, const Action& action) {
  std::vector<std::exception_ptr> failures(explorers.size());
  int done = 0;
  session.progress.start(label, static_cast<double>(explorers.size()));
#pragma omp parallel for schedule(dynamic) num_threads(session.threads)
  for (std::size_t i = 0; i < explorers.size(); ++i) {
    try {
      if (!Interrupt::requested()) action(*explorers[i]);
    } catch (...) {
      failures[i] = std::current_exception();
    }
#pragma omp critical(zona_search_progress)
    session.progress.update(++done);
  }
  session.progress.finish();
  for (const auto& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace

TipMeter::TipMeter(const Plan& plan, Settings common) : plan_(plan), common_(std::move(common)) {
  Response reference = response({});
  reference_values_ = std::move(reference.values);
  reference_values_["mismatch"] = 0;
  reference_window_ = std::move(reference.window);
}

TipHistories TipMeter::histories(const Configuration& study, const std::string& pipette) {
  const beam::Fluid fluid = fills_of(study).front();
  if (study.choice("beam.integrator") != "transform") return beam_tip_histories(study, fluid);
  if (pipette != last_pipette_) {
    lateral_transfer_.clear();
    axial_transfer_.clear();
    last_pipette_ = pipette;
  }
  const beam::Sampling sampling = sampling_from(study, "beam");
  const beam::SupportMotion pulse = support_motion(study, study.quantity("pulse.duration"));
  const auto history = [&](std::vector<std::complex<double>>& transfer, auto&& make_system,
                           double part) -> std::optional<beam::TipHistory> {
    if (part == 0) return std::nullopt;
    if (transfer.empty())
      transfer = beam::TransferFunction(make_system(pipette_from(study, "beam", fluid)))
                     .at(beam::transform_points(sampling));
    return beam::history_by_transform(transfer, part == 1 ? pulse : beam::scaled(pulse, part),
                                      sampling);
  };
  const PulseDirection part = pulse_direction(study);
  return {history(lateral_transfer_, beam::cantilever, part.across),
          history(axial_transfer_, beam::axial_rod, part.along)};
}

TipMeter::Response TipMeter::response(const Settings& settings) {
  Settings all = common_;
  all.insert(all.end(), settings.begin(), settings.end());
  const Configuration study = plan_.study(all);
  const TipHistories tip = histories(study, pipette_part(all));
  const coupling::TipMotion motion = tip_motion(study, tip);
  if (window_length_ == 0) window_length_ = motion.length();
  Response response;
  double travel = 0;
  for (int i = 0; i <= kWindowSamples; ++i) {
    const double time = std::min(window_length_ * i / kWindowSamples, motion.length());
    response.window.push_back(motion(time).displacement);
    travel = std::max(travel, response.window.back().norm());
  }
  const std::vector<double>& times = (tip.lateral ? tip.lateral : tip.axial)->time;
  double amplitude = 0, speed = 0, residual = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto size = [&](std::vector<double> beam::TipHistory::*values) {
      return std::hypot(tip.lateral ? ((*tip.lateral).*values)[i] : 0,
                        tip.axial ? ((*tip.axial).*values)[i] : 0);
    };
    const double here = size(&beam::TipHistory::displacement);
    amplitude = std::max(amplitude, here);
    speed = std::max(speed, size(&beam::TipHistory::velocity));
    if (times[i] > motion.start() + motion.length()) residual = std::max(residual, here);
  }
  response.values = {{"tip_amplitude", amplitude},
                     {"tip_travel", travel},
                     {"peak_velocity", speed},
                     {"residual_motion", residual},
                     {"support_peak", beam::peak_displacement(support_motion(
                                          study, study.quantity("pulse.duration")))}};
  return response;
}

std::optional<Values> TipMeter::measure(const Settings& settings) {
  try {
    Response design = response(settings);
    double difference = 0, size = 0;
    for (int i = 0; i <= kWindowSamples; ++i) {
      difference += (design.window[i] - reference_window_[i]).squaredNorm();
      size += reference_window_[i].squaredNorm();
    }
    design.values["mismatch"] = std::sqrt(difference / size);
    return design.values;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

TipStage explore(const Plan& plan, Session& session) {
  std::vector<std::unique_ptr<Explorer>> explorers;
  const auto choices = combinations(plan.variables);
  for (std::size_t i = 0; i < choices.size(); ++i)
    explorers.push_back(std::make_unique<Explorer>(plan, i, choices[i]));
  for_all(explorers, "beams: hypercube", session, [](Explorer& explorer) { explorer.sample(); });
  std::vector<Design> sampled;
  for (const auto& explorer : explorers)
    sampled.insert(sampled.end(), explorer->designs().begin(), explorer->designs().end());
  if (!sampled.empty()) {
    const Scale scale = scale_of(plan, sampled);
    for_all(explorers, "beams: optimiser", session,
            [&](Explorer& explorer) { explorer.optimise(scale); });
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
    // What does not divide evenly goes to the first combinations.
    const std::size_t share =
        plan.candidates / combination_count + (c < plan.candidates % combination_count ? 1 : 0);
    for (const std::size_t i : spread(front_points, share)) chosen.push_back(numbers[front[i]]);
  }
  return chosen;
}

}  // namespace zona::studies::search
