#include "studies/kinds/search/run.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>

#include "studies/kinds/search/cache_table.h"
#include "studies/kinds/search/case_store.h"
#include "studies/kinds/search/pareto.h"
#include "studies/kinds/search/record_files.h"
#include "studies/parameters/fill_table.h"
#include "studies/run/interrupt.h"
#include "studies/run/progress.h"
#include "studies/run/resolved_study.h"
#include "studies/run/run_directory.h"

namespace zona::studies::search {

namespace {

using nlohmann::json;

std::vector<Sample> samples_of(const Plan& plan) {
  std::vector<Sample> samples;
  if (plan.uncertain.empty()) return samples;
  for (const auto& place :
       latin_hypercube(plan.uncertain.size(), plan.uncertainty_samples, plan.seed)) {
    Sample sample;
    for (std::size_t i = 0; i < place.size(); ++i) {
      const Dimension& input = plan.uncertain[i];
      const auto number =
          static_cast<std::size_t>(place[i] * static_cast<double>(input.values.size()));
      sample.overrides.push_back(input.is_list() ? input.choose(number) : input.at(place[i]));
      sample.values.push_back(input.is_list() ? static_cast<double>(number)
                                              : input.value(place[i]));
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

Overrides combined(const Overrides& a, const Overrides& b) {
  Overrides both = a;
  both.insert(both.end(), b.begin(), b.end());
  return both;
}

bool is_free_of(const Configuration& study, const std::vector<std::string>& avoid) {
  const auto avoided = [&](const std::string& fluid) {
    return std::find(avoid.begin(), avoid.end(), fluid) != avoid.end();
  };
  const auto columns = study.read_all<FluidColumn>();
  return !avoided(study.value(&Fill::fluid).text) &&
         std::none_of(columns.begin(), columns.end(),
                      [&](const FluidColumn& column) { return avoided(column.fluid.text); });
}

/// The listed values in words, and a number where a combination has several designs.
std::string label_of(const Plan& plan, const Design& design, int number) {
  std::string label;
  for (std::size_t i = 0; i < plan.variables.size(); ++i)
    if (plan.variables[i].is_list())
      label += (label.empty() ? "" : " ") + shown_value(design.overrides[i]);
  return fmt::format("{} {}", label.empty() ? "design" : label, number);
}

std::filesystem::path folder_of_cases(const Configuration& study, const Session& session) {
  const std::string cache = study.value(&Cache::folder);
  return cache.empty() ? session.directory.file("cases") : std::filesystem::path(cache);
}

/// A search while it runs.
class SearchRun {
 public:
  SearchRun(const Configuration& study, Session& session)
      : session_(session), store_(folder_of_cases(study, session)), record_{plan_from(study)} {
    record_.samples = samples_of(plan_);
  }

  void run() {
    keep_reference();
    explore_tips();
    if (Interrupt::requested()) return;
    pierce_candidates();
    if (!Interrupt::requested()) refine_candidates();
    if (!Interrupt::requested()) pierce_finalists();
    if (!Interrupt::requested()) pierce_ends();
    write_record(record_, session_);
  }

 private:
  /// From here on the study in the run's directory counts, whatever happens to the original.
  void keep_reference();
  void explore_tips();
  void pierce_candidates();
  void refine_candidates();
  void pierce_finalists();
  void pierce_ends();
  /// Numbers of the candidates that the second optimiser starts from.
  std::vector<std::size_t> starts() const;
  Candidate candidate_of(const std::string& label, const Design& design) const;
  /// Takes the result of a candidate's piercing with the base's inputs.
  void take_result(const Configuration& piercing, const json& result, Candidate& candidate) const;

  Session& session_;
  CaseStore store_;
  Record record_;
  Plan& plan_ = record_.plan;
  std::vector<Design> designs_;  ///< of the candidates
};

void SearchRun::keep_reference() {
  const auto file = session_.directory.file("reference.toml");
  if (!session_.resume || !std::filesystem::exists(file))
    session_.directory.write("reference.toml", resolved_study(plan_.base));
  plan_.base = load_reference(file);
}

void SearchRun::explore_tips() {
  const auto started = std::chrono::steady_clock::now();
  record_.tips = explore(plan_, session_);
  record_.tip_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  session_.directory.log().info(fmt::format("{} designs, {} impossible ones, {:.1f} s",
                                            record_.tips.designs.size(), record_.tips.impossible,
                                            record_.tip_seconds));
  write_designs(record_, session_.directory);
}

void SearchRun::pierce_candidates() {
  const std::vector<std::size_t> chosen = choose_candidates(plan_, record_.tips);
  if (chosen.empty())
    throw RunError(fmt::format(
        "none of {} designs keeps to the limits of the tip; widen the ranges or the limits "
        "(designs.csv has what the tips do)",
        record_.tips.designs.size()));
  std::vector<Configuration> studies{plan_.base};
  record_.reference = {
      "reference", {}, is_free_of(plan_.base, plan_.avoid), "", record_.tips.reference};
  int number = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Design& design = record_.tips.designs[chosen[i]];
    const bool is_same = i > 0 && designs_.back().combination == design.combination;
    number = is_same ? number + 1 : 1;
    studies.push_back(plan_.study(design.overrides));
    record_.candidates.push_back(candidate_of(label_of(plan_, design, number), design));
    designs_.push_back(design);
  }
  const auto results = store_.run(studies, "piercings of candidates", session_);
  for (std::size_t i = 0; i < results.size(); ++i)
    take_result(studies[i], results[i], i == 0 ? record_.reference : record_.candidates[i - 1]);
}

Candidate SearchRun::candidate_of(const std::string& label, const Design& design) const {
  return {label, design.overrides, is_free_of(plan_.study(design.overrides), plan_.avoid), "",
          design.tip};
}

void SearchRun::take_result(const Configuration& piercing, const json& result,
                            Candidate& candidate) const {
  candidate.folder = store_.folder_of(piercing).string();
  candidate.nominal = all_values(candidate.nominal, result);
  if (result.contains("warnings")) candidate.warnings = result["warnings"];
}

std::vector<std::size_t> SearchRun::starts() const {
  std::vector<std::size_t> best;
  if (plan_.refinements == 0 || designs_.front().place.empty()) return best;
  for (const std::size_t i : nominal_order(plan_, record_.candidates)) {
    const bool is_first = std::none_of(best.begin(), best.end(), [&](std::size_t other) {
      return designs_[other].combination == designs_[i].combination;
    });
    if (is_first && best.size() < plan_.finalist_count()) best.push_back(i);
  }
  return best;
}

void SearchRun::refine_candidates() {
  const std::vector<std::size_t> from = starts();
  std::vector<Design> designs;
  for (const std::size_t i : from) designs.push_back(designs_[i]);
  record_.evaluations = refine(plan_, designs, record_.reference.nominal, store_, session_);
  for (std::size_t k = 0; k < from.size(); ++k) {
    const Evaluation* best = nullptr;
    for (const Evaluation& evaluation : record_.evaluations)
      if (evaluation.start == k && (best == nullptr || evaluation.cost < best->cost))
        best = &evaluation;
    // The first evaluation is the start itself.
    if (best == nullptr || best->design.overrides == designs[k].overrides) continue;
    Candidate found = candidate_of(record_.candidates[from[k]].label + " refined", best->design);
    const Configuration piercing = plan_.study(best->design.overrides);
    take_result(piercing, store_.result(piercing), found);
    record_.candidates.push_back(found);
    designs_.push_back(best->design);
  }
}

void SearchRun::pierce_finalists() {
  record_.finalists = nominal_order(plan_, record_.candidates);
  record_.finalists.resize(std::min(record_.finalists.size(), plan_.finalist_count()));
  if (record_.samples.empty())
    record_.samples.push_back({});  // nothing is uncertain: the base's inputs
  std::vector<Configuration> studies;
  for (const Sample& sample : record_.samples) {
    studies.push_back(plan_.study(sample.overrides));
    for (const std::size_t i : record_.finalists)
      studies.push_back(plan_.study(combined(sample.overrides, record_.candidates[i].overrides)));
  }
  const auto results = store_.run(studies, "piercings with uncertain inputs", session_);
  if (Interrupt::requested()) return;
  std::size_t next = 0;
  for (const Sample& sample : record_.samples) {
    TipMeter meter(plan_, sample.overrides);
    record_.reference.samples.push_back(all_values(meter.reference(), results[next++]));
    for (const std::size_t i : record_.finalists)
      record_.candidates[i].samples.push_back(all_values(
          meter.measure(record_.candidates[i].overrides).value_or(Values{}), results[next++]));
  }
  std::vector<Candidate> judged;
  for (const std::size_t i : record_.finalists) judged.push_back(record_.candidates[i]);
  const std::vector<Verdict> verdicts = judge(plan_, record_.reference, judged);
  std::vector<std::size_t> ranked;
  for (const std::size_t place : final_order(plan_, verdicts)) {
    ranked.push_back(record_.finalists[place]);
    record_.verdicts.push_back(verdicts[place]);
  }
  record_.finalists = ranked;
  record_.reference_verdict = judge(plan_, record_.reference, {record_.reference}).front();
}

void SearchRun::pierce_ends() {
  if (!plan_.derivatives || plan_.uncertain.empty()) return;
  const auto answer = std::find_if(record_.verdicts.begin(), record_.verdicts.end(),
                                   [](const Verdict& verdict) { return verdict.is_answer; });
  const std::size_t best =
      answer == record_.verdicts.end()
          ? record_.finalists.front()
          : record_.finalists[static_cast<std::size_t>(answer - record_.verdicts.begin())];
  std::vector<Configuration> studies;
  for (std::size_t input = 0; input < plan_.uncertain.size(); ++input) {
    for (const bool is_high : {false, true}) {
      const Dimension& dimension = plan_.uncertain[input];
      const Overrides end{dimension.is_list()
                              ? dimension.choose(is_high ? dimension.values.size() - 1 : 0)
                              : dimension.at(is_high ? 1 : 0)};
      TipMeter meter(plan_, end);
      for (const Candidate* subject : {&record_.reference, &record_.candidates[best]}) {
        studies.push_back(plan_.study(combined(end, subject->overrides)));
        record_.ends.push_back(
            {input, is_high, subject->label, meter.measure(subject->overrides).value_or(Values{})});
      }
    }
  }
  const auto results = store_.run(studies, "derivatives", session_);
  for (std::size_t i = 0; i < record_.ends.size(); ++i)
    record_.ends[i].values = all_values(record_.ends[i].values, results[i]);
  if (Interrupt::requested()) record_.ends.clear();
}

}  // namespace

void run_search(const Configuration& search, Session& session) {
  SearchRun(search, session).run();
}

SearchSize size_of(const Plan& plan) {
  const auto count = static_cast<double>(combinations(plan.variables).size());
  const auto ranges = std::count_if(plan.variables.begin(), plan.variables.end(),
                                    [](const Dimension& variable) { return !variable.is_list(); });
  const auto weightings =
      static_cast<double>(simplex_lattice(plan.tip_objectives.size(), plan.divisions).size());
  const double beams = ranges == 0 ? count
                                   : count * (static_cast<double>(plan.samples) +
                                              weightings * static_cast<double>(plan.evaluations));
  const double samples = plan.uncertain.empty() ? 0 : static_cast<double>(plan.uncertainty_samples);
  const double ends = plan.derivatives ? 4 * static_cast<double>(plan.uncertain.size()) : 0;
  const auto refined =
      ranges == 0 ? 0
                  : static_cast<double>(plan.refinements *
                                        std::min<std::size_t>(plan.finalist_count(),
                                                              combinations(plan.variables).size()));
  return {beams, 1 + static_cast<double>(plan.candidates) + refined +
                     samples * (1 + static_cast<double>(plan.finalist_count())) + ends};
}

}  // namespace zona::studies::search
