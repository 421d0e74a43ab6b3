#include "studies/kinds/search/ranking_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/input/parameter.h"

namespace zona::studies::search {

namespace {

std::string heading(const Plan& plan) {
  std::string text = fmt::format("{:>4}  {:<24}{:>7}", "rank", "design", "limits");
  for (const Measure* m : plan.objectives)
    text +=
        fmt::format("{:>28}", m->title + (m->shown_unit.empty() ? "" : " [" + m->shown_unit + "]"));
  return text + "  better\n";
}

std::string spread_text(const Measure& measure, const Verdict& verdict) {
  const auto found = verdict.measures.find(measure.name);
  if (found == verdict.measures.end()) return "unknown";
  const Spread& s = found->second;
  return fmt::format("{} ({}-{})", shown_number(measure, s.median), shown_number(measure, s.low),
                     shown_number(measure, s.high));
}

std::string row(const std::string& rank, const Candidate& candidate, const Verdict& verdict,
                const Plan& plan) {
  std::string text =
      fmt::format("{:>4}  {:<24}{:>5.0f} %", rank, candidate.label, 100 * verdict.keeps_limits);
  for (const Measure* measure : plan.objectives)
    text += fmt::format("{:>28}", spread_text(*measure, verdict));
  const auto first = verdict.measures.find(plan.objectives.front()->name);
  if (first == verdict.measures.end()) return text + "\n";
  return text +
         fmt::format("{:>6.0f} %{}\n", 100 * first->second.better, verdict.is_answer ? "  *" : "");
}

std::string answer_text(const Record& record) {
  const auto answers = std::count_if(record.verdicts.begin(), record.verdicts.end(),
                                     [](const Verdict& verdict) { return verdict.is_answer; });
  const std::string without =
      record.plan.avoid.empty() ? "" : " without " + joined(record.plan.avoid);
  if (answers > 0) {
    return fmt::format(
        "{} designs{} (*) keep to the limits and are better in at least {:.0f} % of the "
        "samples.\n",
        answers, without, 100 * record.plan.confidence);
  }
  return fmt::format(
      "No design{} keeps to the limits and is better in {:.0f} % of the samples, in the ranges "
      "tried.\n",
      without, 100 * record.plan.confidence);
}

}  // namespace

std::string ranking_text(const Record& record) {
  const Plan& plan = record.plan;
  std::string text = heading(plan) + row("", record.reference, *record.reference_verdict, plan);
  for (std::size_t r = 0; r < record.finalists.size(); ++r)
    text += row(std::to_string(r + 1), record.candidates[record.finalists[r]], record.verdicts[r],
                plan);
  text += fmt::format(
      "Medians over {} samples of the uncertain inputs, 5 to 95 % in brackets. Better: share of "
      "the samples in which {} is below the reference's.\n",
      record.samples.size(), plan.objectives.front()->title);
  text += answer_text(record);
  for (const End& end : record.ends)
    if (!keeps(plan.limits_of(Measure::Of::oocyte), end.values))
      text += fmt::format("With {} at the {} end of its range {} violates the limits.\n",
                          plan.uncertain[end.input].key, end.is_high ? "high" : "low", end.subject);
  return text;
}

}  // namespace zona::studies::search
