#include "studies/search_study.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "studies/beam_parameters.h"
#include "studies/history_file.h"
#include "studies/interrupt.h"
#include "studies/piercing_case.h"
#include "studies/piercing_run.h"
#include "studies/progress.h"
#include "studies/resolved_study.h"
#include "studies/run_directory.h"
#include "studies/search/case_store.h"
#include "studies/search/pareto.h"
#include "studies/search/ranking.h"
#include "studies/trial.h"

namespace zona::studies {

namespace {

using namespace search;
using nlohmann::json;

/// The uncertain inputs of one sample.
struct Sample {
  Settings settings;
  std::vector<double> values;  ///< in the units of the inputs; the number of a listed value
};

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
      sample.settings.push_back(input.is_list() ? input.choose(number) : input.at(place[i]));
      sample.values.push_back(input.is_list() ? static_cast<double>(number)
                                              : input.value(place[i]));
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

Settings joined_settings(const Settings& a, const Settings& b) {
  Settings both = a;
  both.insert(both.end(), b.begin(), b.end());
  return both;
}

bool is_free_of(const Configuration& study, const std::vector<std::string>& avoid) {
  const auto avoided = [&](const std::string& fluid) {
    return std::find(avoid.begin(), avoid.end(), fluid) != avoid.end();
  };
  const auto columns = study.items("column");
  return !avoided(study.text("fill.fluid")) &&
         std::none_of(columns.begin(), columns.end(),
                      [&](const Table& column) { return avoided(column.text("fluid")); });
}

/// Measures of the tip and, where the piercing has come to results, of the oocyte.
Values all_values(const Values& tip, const json& piercing) {
  Values values = tip;
  for (const std::string& name : measure_names(Measure::Of::oocyte))
    if (piercing.contains(name) && piercing[name].is_number())
      values[name] = piercing[name].get<double>();
  return values;
}

/// The listed values in words, and a number where a combination has several designs.
std::string label_of(const Plan& plan, const Design& design, int number) {
  std::string label;
  for (std::size_t i = 0; i < plan.variables.size(); ++i)
    if (plan.variables[i].is_list())
      label += (label.empty() ? "" : " ") + shown_value(design.settings[i]);
  return fmt::format("{} {}", label.empty() ? "design" : label, number);
}

/// A search while it runs.
class SearchRun {
 public:
  SearchRun(const Configuration& study, Session& session)
      : plan_(plan_from(study)),
        session_(session),
        store_(study.text("run.cache").empty() ? session.directory.file("cases")
                                               : std::filesystem::path(study.text("run.cache"))),
        samples_(samples_of(plan_)) {}

  void run() {
    keep_reference();
    explore_tips();
    if (Interrupt::requested()) return;
    pierce_candidates();
    if (!Interrupt::requested()) pierce_finalists();
    if (!Interrupt::requested()) pierce_ends();
    write();
  }

 private:
  /// From here on the study in the run's directory counts, whatever happens to the original.
  void keep_reference();
  void explore_tips();
  void pierce_candidates();
  void pierce_finalists();
  void pierce_ends();
  void write();
  void write_designs() const;
  void write_candidates() const;
  void write_samples() const;
  json candidate_json(const Candidate& candidate) const;
  json uncertain_json() const;
  std::string table() const;

  Plan plan_;
  Session& session_;
  CaseStore store_;
  std::vector<Sample> samples_;
  TipStage tips_;
  double tip_seconds_ = 0;
  Candidate reference_;
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> finalists_;  ///< numbers of candidates, the best first
  std::vector<Verdict> verdicts_;       ///< of the finalists
  std::optional<Verdict> reference_verdict_;

  /// Measures with an uncertain input at an end of its range.
  struct End {
    std::size_t input;
    bool is_high;
    std::string subject;
    Values values;
  };
  std::vector<End> ends_;
};

void SearchRun::keep_reference() {
  const auto file = session_.directory.file("reference.toml");
  if (!session_.resume || !std::filesystem::exists(file))
    session_.directory.write("reference.toml", resolved_study(plan_.base));
  plan_.base = load_configuration(file);
}

void SearchRun::explore_tips() {
  const auto started = std::chrono::steady_clock::now();
  tips_ = explore(plan_, session_);
  tip_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  session_.directory.log().info("{} designs, {} impossible ones, {:.1f} s", tips_.designs.size(),
                                tips_.impossible, tip_seconds_);
  write_designs();
}

void SearchRun::pierce_candidates() {
  const std::vector<std::size_t> chosen = choose_candidates(plan_, tips_);
  if (chosen.empty())
    throw RunError(fmt::format(
        "none of {} designs keeps to the limits of the tip; widen the ranges or the limits "
        "(designs.csv has what the tips do)",
        tips_.designs.size()));
  std::vector<Configuration> studies{plan_.base};
  reference_ = {"reference", {}, is_free_of(plan_.base, plan_.avoid), "", tips_.reference};
  int number = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Design& design = tips_.designs[chosen[i]];
    const bool is_same = i > 0 && tips_.designs[chosen[i - 1]].combination == design.combination;
    number = is_same ? number + 1 : 1;
    studies.push_back(plan_.study(design.settings));
    candidates_.push_back({label_of(plan_, design, number), design.settings,
                           is_free_of(studies.back(), plan_.avoid), "", design.tip});
  }
  const auto results = store_.run(studies, "piercings of candidates", session_);
  for (std::size_t i = 0; i < results.size(); ++i) {
    Candidate& candidate = i == 0 ? reference_ : candidates_[i - 1];
    candidate.folder = store_.folder_of(studies[i]).string();
    candidate.nominal = all_values(candidate.nominal, results[i]);
    if (results[i].contains("warnings")) candidate.warnings = results[i]["warnings"];
  }
}

void SearchRun::pierce_finalists() {
  finalists_ = nominal_order(plan_, candidates_);
  finalists_.resize(std::min(finalists_.size(), plan_.finalists));
  if (samples_.empty()) samples_.push_back({});  // nothing is uncertain: the base's inputs
  std::vector<Configuration> studies;
  for (const Sample& sample : samples_) {
    studies.push_back(plan_.study(sample.settings));
    for (const std::size_t i : finalists_)
      studies.push_back(plan_.study(joined_settings(sample.settings, candidates_[i].settings)));
  }
  const auto results = store_.run(studies, "piercings with uncertain inputs", session_);
  if (Interrupt::requested()) return;
  std::size_t next = 0;
  for (const Sample& sample : samples_) {
    TipMeter meter(plan_, sample.settings);
    reference_.samples.push_back(all_values(meter.reference(), results[next++]));
    for (const std::size_t i : finalists_)
      candidates_[i].samples.push_back(
          all_values(meter.measure(candidates_[i].settings).value_or(Values{}), results[next++]));
  }
  std::vector<Candidate> judged;
  for (const std::size_t i : finalists_) judged.push_back(candidates_[i]);
  const std::vector<Verdict> verdicts = judge(plan_, reference_, judged);
  std::vector<std::size_t> ranked;
  for (const std::size_t place : final_order(plan_, verdicts)) {
    ranked.push_back(finalists_[place]);
    verdicts_.push_back(verdicts[place]);
  }
  finalists_ = ranked;
  reference_verdict_ = judge(plan_, reference_, {reference_}).front();
}

void SearchRun::pierce_ends() {
  if (!plan_.derivatives || plan_.uncertain.empty()) return;
  const auto answer = std::find_if(verdicts_.begin(), verdicts_.end(),
                                   [](const Verdict& verdict) { return verdict.is_answer; });
  const std::size_t best = answer == verdicts_.end()
                               ? finalists_.front()
                               : finalists_[static_cast<std::size_t>(answer - verdicts_.begin())];
  std::vector<Configuration> studies;
  for (std::size_t input = 0; input < plan_.uncertain.size(); ++input) {
    for (const bool is_high : {false, true}) {
      const Dimension& dimension = plan_.uncertain[input];
      const Settings end{dimension.is_list()
                             ? dimension.choose(is_high ? dimension.values.size() - 1 : 0)
                             : dimension.at(is_high ? 1 : 0)};
      TipMeter meter(plan_, end);
      for (const Candidate* subject : {&reference_, &candidates_[best]}) {
        studies.push_back(plan_.study(joined_settings(end, subject->settings)));
        ends_.push_back(
            {input, is_high, subject->label, meter.measure(subject->settings).value_or(Values{})});
      }
    }
  }
  const auto results = store_.run(studies, "derivatives", session_);
  for (std::size_t i = 0; i < ends_.size(); ++i)
    ends_[i].values = all_values(ends_[i].values, results[i]);
  if (Interrupt::requested()) ends_.clear();
}

void SearchRun::write_designs() const {
  std::vector<Column> columns{{"design", ""}};
  for (const Dimension& variable : plan_.variables)
    if (!variable.is_list()) columns.push_back({variable.key, variable.unit});
  for (const std::string& name : measure_names(Measure::Of::tip))
    columns.push_back({name, find_measure(name).unit});
  HistoryFile file(session_.directory.file("designs.csv"), columns);
  for (const Design& design : tips_.designs) {
    std::string words;
    std::vector<double> row;
    for (std::size_t i = 0; i < plan_.variables.size(); ++i) {
      const std::string value = shown_value(design.settings[i]);
      if (plan_.variables[i].is_list()) {
        words += (words.empty() ? "" : "; ") + value;
      } else {
        row.push_back(std::stod(value));
      }
    }
    for (const std::string& name : measure_names(Measure::Of::tip))
      row.push_back(design.tip.at(name));
    std::replace(words.begin(), words.end(), ',', ';');
    file.add(words.empty() ? "design" : words, row);
  }
}

void SearchRun::write_samples() const {
  std::vector<Column> columns{{"design", ""}, {"sample", ""}};
  for (const Dimension& input : plan_.uncertain) columns.push_back({input.key, input.unit});
  for (const Measure& measure : measures()) columns.push_back({measure.name, measure.unit});
  HistoryFile file(session_.directory.file("samples.csv"), columns);
  std::vector<const Candidate*> subjects{&reference_};
  for (const std::size_t i : finalists_) subjects.push_back(&candidates_[i]);
  for (const Candidate* subject : subjects) {
    for (std::size_t s = 0; s < subject->samples.size(); ++s) {
      std::vector<double> row{static_cast<double>(s)};
      row.insert(row.end(), samples_[s].values.begin(), samples_[s].values.end());
      for (const Measure& measure : measures()) {
        const auto found = subject->samples[s].find(measure.name);
        row.push_back(found == subject->samples[s].end() ? std::nan("") : found->second);
      }
      file.add(subject->label, row);
    }
  }
}

/// Study files of the finalists, by rank, to be run as they are, with frames.
void SearchRun::write_candidates() const {
  std::filesystem::create_directories(session_.directory.file("candidates"));
  for (std::size_t rank = 0; rank < finalists_.size(); ++rank) {
    const Candidate& candidate = candidates_[finalists_[rank]];
    session_.directory.write(fmt::format("candidates/{}.toml", rank + 1),
                             resolved_study(plan_.study(candidate.settings)));
  }
}

json SearchRun::candidate_json(const Candidate& candidate) const {
  json settings = json::object();
  for (const std::string& setting : candidate.settings)
    settings[key_of(setting)] = shown_value(setting);
  return {{"label", candidate.label},       {"settings", settings},
          {"avoids", candidate.is_free},    {"folder", candidate.folder},
          {"warnings", candidate.warnings}, {"nominal", candidate.nominal}};
}

json verdict_json(const Verdict& verdict) {
  json measures = json::object();
  for (const auto& [name, spread] : verdict.measures)
    measures[name] = {{"median", spread.median},
                      {"low", spread.low},
                      {"high", spread.high},
                      {"better", spread.better}};
  return {{"measures", measures},
          {"keeps_limits", verdict.keeps_limits},
          {"level", verdict.level},
          {"is_answer", verdict.is_answer}};
}

/// The uncertain inputs: how much they matter, and what their ends come to.
json SearchRun::uncertain_json() const {
  std::vector<const Candidate*> subjects{&reference_};
  for (const std::size_t i : finalists_) subjects.push_back(&candidates_[i]);
  json inputs = json::array();
  for (std::size_t i = 0; i < plan_.uncertain.size(); ++i) {
    const Dimension& input = plan_.uncertain[i];
    std::vector<double> values;
    for (const Sample& sample : samples_) values.push_back(sample.values[i]);
    json correlations = json::object();
    for (const Measure* objective : plan_.objectives)
      correlations[objective->name] = mean_correlation(values, subjects, objective->name);
    json ends = json::array();
    for (const End& end : ends_)
      if (end.input == i)
        ends.push_back({{"subject", end.subject},
                        {"end", end.is_high ? "high" : "low"},
                        {"values", end.values}});
    json entry = {{"key", input.key},  {"unit", input.unit},           {"source", input.source},
                  {"samples", values}, {"correlations", correlations}, {"ends", ends}};
    if (input.is_list()) {
      entry["values"] = input.values;
    } else {
      entry["range"] = {input.low, input.high};
    }
    inputs.push_back(entry);
  }
  return inputs;
}

std::string SearchRun::table() const {
  const auto cell = [](const Measure& measure, const Verdict& verdict) {
    const auto found = verdict.measures.find(measure.name);
    if (found == verdict.measures.end()) return std::string("unknown");
    const Spread& s = found->second;
    return fmt::format("{} ({}-{})", shown_number(measure, s.median), shown_number(measure, s.low),
                       shown_number(measure, s.high));
  };
  std::string text = fmt::format("{:>4}  {:<24}{:>7}", "rank", "design", "limits");
  for (const Measure* m : plan_.objectives)
    text +=
        fmt::format("{:>28}", m->title + (m->shown_unit.empty() ? "" : " [" + m->shown_unit + "]"));
  text += "  better\n";
  const auto add = [&](const std::string& rank, const Candidate& candidate,
                       const Verdict& verdict) {
    text +=
        fmt::format("{:>4}  {:<24}{:>5.0f} %", rank, candidate.label, 100 * verdict.keeps_limits);
    for (const Measure* measure : plan_.objectives)
      text += fmt::format("{:>28}", cell(*measure, verdict));
    const auto first = verdict.measures.find(plan_.objectives.front()->name);
    text += first == verdict.measures.end()
                ? "\n"
                : fmt::format("{:>6.0f} %{}\n", 100 * first->second.better,
                              verdict.is_answer ? "  *" : "");
  };
  add("", reference_, *reference_verdict_);
  for (std::size_t r = 0; r < finalists_.size(); ++r)
    add(std::to_string(r + 1), candidates_[finalists_[r]], verdicts_[r]);
  const auto answers = std::count_if(verdicts_.begin(), verdicts_.end(),
                                     [](const Verdict& verdict) { return verdict.is_answer; });
  text += fmt::format(
      "Medians over {} samples of the uncertain inputs, 5 to 95 % in brackets. Better: share of "
      "the samples in which {} is below the reference's.\n",
      samples_.size(), plan_.objectives.front()->title);
  const std::string without = plan_.avoid.empty() ? "" : " without " + joined(plan_.avoid);
  text += answers > 0 ? fmt::format(
                            "{} designs{} (*) keep to the limits and are better in at least "
                            "{:.0f} % of the samples.\n",
                            answers, without, 100 * plan_.confidence)
                      : fmt::format(
                            "No design{} keeps to the limits and is better in {:.0f} % of the "
                            "samples, in the ranges tried.\n",
                            without, 100 * plan_.confidence);
  return text;
}

void SearchRun::write() {
  json& results = session_.results;
  results["beams"] = {{"designs", tips_.designs.size()},
                      {"impossible", tips_.impossible},
                      {"seconds", tip_seconds_}};
  json titles = json::object();
  for (const Measure& measure : measures())
    titles[measure.name] = {{"title", measure.title},
                            {"factor", measure.shown_factor},
                            {"unit", measure.shown_unit},
                            {"meaning", measure.documentation}};
  results["measures"] = titles;
  results["tip_objectives"] = json::array();
  for (const Measure* objective : plan_.tip_objectives)
    results["tip_objectives"].push_back(objective->name);
  json limits = json::array();
  for (const Limit& limit : plan_.limits) limits.push_back(limit.text());
  results["limits"] = limits;
  json objectives = json::array();
  for (const Measure* objective : plan_.objectives) objectives.push_back(objective->name);
  results["objectives"] = objectives;
  results["avoid"] = plan_.avoid;
  results["confidence"] = plan_.confidence;
  results["reference"] = candidate_json(reference_);
  if (reference_verdict_) results["reference"].update(verdict_json(*reference_verdict_));
  json list = json::array();
  for (const Candidate& candidate : candidates_) list.push_back(candidate_json(candidate));
  for (std::size_t rank = 0; rank < verdicts_.size(); ++rank) {
    list[finalists_[rank]].update(verdict_json(verdicts_[rank]));
    list[finalists_[rank]]["rank"] = rank + 1;
  }
  results["candidates"] = list;
  if (verdicts_.empty()) return;  // interrupted
  results["uncertain"] = uncertain_json();
  write_samples();
  write_candidates();
  session_.conclusion = table();
  session_.directory.write("ranking.txt", session_.conclusion);
}

/// Beams and piercings of a search.
struct Size {
  double beams, piercings;
};

Size size_of(const Plan& plan) {
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
  return {beams, 1 + static_cast<double>(plan.candidates) +
                     samples * (1 + static_cast<double>(plan.finalists)) + ends};
}

PiercingCase reference_case(const Plan& plan) {
  return make_piercing_case(plan.base, fills_of(plan.base).front());
}

}  // namespace

Job prepare_search(const Configuration& study) {
  const Plan plan = plan_from(study);
  reference_case(plan);
  return [study](Session& session) { SearchRun(study, session).run(); };
}

StudyCost estimate_search(const Configuration& study) {
  const Plan plan = plan_from(study);
  const Size size = size_of(plan);
  const StudyCost one = piercing_cost(reference_case(plan));
  return {fmt::format("at most {:.0f} beams and {:.0f} piercings, each as the reference: {}",
                      size.beams, size.piercings, one.text),
          one.point_steps * size.piercings};
}

std::string try_search(const Configuration& study, int threads) {
  const Plan plan = plan_from(study);
  const Size size = size_of(plan);
  TipMeter(plan, {});  // loads what computes beams
  const auto started = std::chrono::steady_clock::now();
  TipMeter(plan, {});
  const double beam =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  const auto trial = [&] {
    const PiercingCase reference = reference_case(plan);
    OutputPlan output = output_plan(plan.base, reference.end);
    output.fields = false;
    Trial one =
        try_simulation(build_piercing(reference.setup), reference.step, reference.end, output, 1);
    one.seconds = (one.seconds * size.piercings + beam * size.beams) / threads;
    one.memory += one.own * (threads - 1);
    one.disk = 0;
    return one;
  };
  return trial_text(trial, threads);
}

}  // namespace zona::studies
