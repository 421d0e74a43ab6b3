#include "studies/kinds/search/record_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/kinds/search/ranking_text.h"
#include "studies/run/history_file.h"
#include "studies/run/resolved_study.h"

namespace zona::studies::search {

namespace {

using nlohmann::json;

/// Columns of the variables that are ranges.
void add_ranges(const Plan& plan, std::vector<Column>& columns) {
  for (const Dimension& variable : plan.variables)
    if (!variable.is_list()) columns.push_back({variable.key, variable.unit});
}

/// The listed values of a design in words, and its numbers.
std::pair<std::string, std::vector<double>> words_and_numbers(const Plan& plan,
                                                              const Overrides& overrides) {
  std::string words;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < plan.variables.size(); ++i) {
    const std::string value = shown_value(overrides[i]);
    if (plan.variables[i].is_list()) {
      words += (words.empty() ? "" : "; ") + value;
    } else {
      numbers.push_back(std::stod(value));
    }
  }
  std::replace(words.begin(), words.end(), ',', ';');
  return {words.empty() ? "design" : words, numbers};
}

double value_or_nan(const Values& values, const std::string& measure) {
  const auto found = values.find(measure);
  return found == values.end() ? std::nan("") : found->second;
}

void write_samples(const Record& record, const RunDirectory& directory) {
  std::vector<Column> columns{{"design", ""}, {"sample", ""}};
  for (const Dimension& input : record.plan.uncertain) columns.push_back({input.key, input.unit});
  for (const Measure& measure : measures()) columns.push_back({measure.name, measure.unit});
  HistoryFile file(directory.file("samples.csv"), columns);
  std::vector<const Candidate*> subjects{&record.reference};
  for (const std::size_t i : record.finalists) subjects.push_back(&record.candidates[i]);
  for (const Candidate* subject : subjects) {
    for (std::size_t s = 0; s < subject->samples.size(); ++s) {
      std::vector<double> row{static_cast<double>(s)};
      row.insert(row.end(), record.samples[s].values.begin(), record.samples[s].values.end());
      for (const Measure& measure : measures())
        row.push_back(value_or_nan(subject->samples[s], measure.name));
      file.add(subject->label, row);
    }
  }
}

/// Evaluations of the local searches, one search after the other.
void write_evaluations(const Record& record, const RunDirectory& directory) {
  if (record.evaluations.empty()) return;
  std::vector<Column> columns{{"design", ""}, {"way", ""}};
  add_ranges(record.plan, columns);
  columns.push_back({"cost", ""});
  for (const Measure& measure : measures()) columns.push_back({measure.name, measure.unit});
  HistoryFile file(directory.file("trials.csv"), columns);
  for (const Evaluation& evaluation : record.evaluations) {
    const auto [words, numbers] = words_and_numbers(record.plan, evaluation.design.overrides);
    std::vector<double> row{static_cast<double>(evaluation.start + 1)};
    row.insert(row.end(), numbers.begin(), numbers.end());
    row.push_back(evaluation.cost);
    for (const Measure& measure : measures())
      row.push_back(value_or_nan(evaluation.values, measure.name));
    file.add(words, row);
  }
}

/// Study files of the finalists, by rank, to be run as they are, with frames.
void write_candidates(const Record& record, const RunDirectory& directory) {
  std::filesystem::create_directories(directory.file("candidates"));
  for (std::size_t rank = 0; rank < record.finalists.size(); ++rank) {
    const Candidate& candidate = record.candidates[record.finalists[rank]];
    directory.write(fmt::format("candidates/{}.toml", rank + 1),
                    resolved_study(record.plan.study(candidate.overrides)));
  }
}

json candidate_json(const Candidate& candidate) {
  json overrides = json::object();
  for (const std::string& entry : candidate.overrides)
    overrides[key_of(entry)] = shown_value(entry);
  return {{"label", candidate.label},       {"settings", overrides},
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

/// The uncertain inputs: correlations with the objectives, and the results at their ends.
json uncertain_json(const Record& record) {
  std::vector<const Candidate*> subjects{&record.reference};
  for (const std::size_t i : record.finalists) subjects.push_back(&record.candidates[i]);
  json inputs = json::array();
  for (std::size_t i = 0; i < record.plan.uncertain.size(); ++i) {
    const Dimension& input = record.plan.uncertain[i];
    std::vector<double> values;
    for (const Sample& sample : record.samples) values.push_back(sample.values[i]);
    json correlations = json::object();
    for (const Measure* objective : record.plan.objectives)
      correlations[objective->name] = mean_correlation(values, subjects, objective->name);
    json ends = json::array();
    for (const End& end : record.ends)
      if (end.input == i)
        ends.push_back(
            {{"subject", end.subject},
             {"end", end.is_high ? "high" : "low"},
             {"keeps_limits", keeps(record.plan.limits_of(Measure::Of::oocyte), end.values)},
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

json measures_json() {
  json titles = json::object();
  for (const Measure& measure : measures())
    titles[measure.name] = {{"title", measure.title},
                            {"factor", measure.shown_factor},
                            {"unit", measure.shown_unit},
                            {"meaning", measure.documentation}};
  return titles;
}

json names_json(const std::vector<const Measure*>& measures) {
  json names = json::array();
  for (const Measure* measure : measures) names.push_back(measure->name);
  return names;
}

json candidates_json(const Record& record) {
  json list = json::array();
  for (const Candidate& candidate : record.candidates) list.push_back(candidate_json(candidate));
  for (std::size_t rank = 0; rank < record.verdicts.size(); ++rank) {
    list[record.finalists[rank]].update(verdict_json(record.verdicts[rank]));
    list[record.finalists[rank]]["rank"] = rank + 1;
  }
  return list;
}

void add_results(const Record& record, json& results) {
  const Plan& plan = record.plan;
  results["beams"] = {{"designs", record.tips.designs.size()},
                      {"impossible", record.tips.impossible},
                      {"seconds", record.tip_seconds}};
  results["measures"] = measures_json();
  results["tip_objectives"] = names_json(plan.tip_objectives);
  json limits = json::array();
  for (const Limit& limit : plan.limits) limits.push_back(limit.text());
  results["limits"] = limits;
  results["objectives"] = names_json(plan.objectives);
  results["avoid"] = plan.avoid;
  results["confidence"] = plan.confidence;
  results["reference"] = candidate_json(record.reference);
  if (record.reference_verdict)
    results["reference"].update(verdict_json(*record.reference_verdict));
  results["candidates"] = candidates_json(record);
  results["trials"] = record.evaluations.size();
}

}  // namespace

void write_designs(const Record& record, const RunDirectory& directory) {
  std::vector<Column> columns{{"design", ""}};
  add_ranges(record.plan, columns);
  for (const std::string& name : measure_names(Measure::Of::tip))
    columns.push_back({name, find_measure(name).unit});
  HistoryFile file(directory.file("designs.csv"), columns);
  for (const Design& design : record.tips.designs) {
    auto [words, row] = words_and_numbers(record.plan, design.overrides);
    for (const std::string& name : measure_names(Measure::Of::tip))
      row.push_back(design.tip.at(name));
    file.add(words, row);
  }
}

void write_record(const Record& record, Session& session) {
  add_results(record, session.results);
  if (record.verdicts.empty()) return;  // interrupted
  session.results["uncertain"] = uncertain_json(record);
  write_samples(record, session.directory);
  write_evaluations(record, session.directory);
  write_candidates(record, session.directory);
  session.conclusion = ranking_text(record);
  session.directory.write("ranking.txt", session.conclusion);
}

}  // namespace zona::studies::search
