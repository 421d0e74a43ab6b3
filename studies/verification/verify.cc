#include "studies/verification/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>

#include "studies/input/nearest.h"
#include "studies/program/exit_code.h"
#include "studies/run/interrupt.h"
#include "studies/run/progress.h"
#include "studies/verification/campaign.h"
#include "studies/verification/page.h"

namespace zona::studies {

namespace fs = std::filesystem;
using namespace verification;

namespace {

/// Point-steps per second of two cores of an ordinary machine, for the forecast.
constexpr double ordinary_rate = 1.5e7;

std::vector<const Case*> chosen_cases(const std::vector<std::string>& names) {
  std::vector<const Case*> chosen;
  std::vector<std::string> known;
  for (const Case& c : cases()) {
    known.push_back(c.name);
    const bool is_named = std::find(names.begin(), names.end(), c.name) != names.end();
    if (names.empty() || is_named) chosen.push_back(&c);
  }
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string nearest = nearest_name(name, known);
    throw InputError("zona verify",
                     fmt::format("there is no case {}; {}", printable(name),
                                 nearest.empty() ? "\"zona verify --list\" lists them"
                                                 : "did you mean " + nearest + "?"));
  }
  return chosen;
}

std::string forecast(double point_steps) {
  return point_steps > 0 ? "about " + duration_text(point_steps / ordinary_rate) : "seconds";
}

void print_plan(const std::vector<const Case*>& chosen, const std::vector<PlannedRun>& runs) {
  double todo = 0;
  fmt::print(stderr, "{:<24} {:>5} {:>5}  {}\n", "case", "runs", "done", "still to compute");
  for (const Case* c : chosen) {
    int count = 0, done = 0;
    double left = 0;
    for (const PlannedRun& run : runs) {
      if (run.owner != c) continue;
      ++count;
      done += run.is_done ? 1 : 0;
      left += run.is_done ? 0 : run.point_steps;
    }
    todo += left;
    fmt::print(
        stderr, "{:<24} {:>5} {:>5}  {}\n", c->name, count, done,
        done == count ? "nothing" : fmt::format("{:.2g} point-steps, {}", left, forecast(left)));
  }
  fmt::print(stderr, "in all {} on two ordinary cores; Ctrl-C stops, the same command continues\n",
             forecast(todo));
}

Check failed_run(const std::string& label, const std::string& message) {
  return {"run " + label, "none", "", "", "complete", message, Verdict::failed};
}

/// Compares the runs of a case with its reference.
CaseReport judge(const Case& c, const std::vector<PlannedRun>& runs,
                 const std::vector<RunReport>& outcomes, Extent extent) {
  CaseReport report{&c, {}, {}, {}};
  CaseResults results;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const PlannedRun& run = runs[i];
    if (run.owner != &c) continue;
    if (outcomes[i].status != "complete") {
      report.evaluation.checks.push_back(failed_run(run.run.label, outcomes[i].message));
      continue;
    }
    RunResults found(run.directory);
    report.runs.push_back(run.run);
    report.wall_seconds.push_back(found.wall_seconds());
    results.add(run.run.label, std::move(found));
  }
  if (!report.evaluation.checks.empty()) return report;
  try {
    report.evaluation = c.evaluate(results, extent);
  } catch (const std::exception& error) {
    report.evaluation.checks = {failed_run("evaluation", error.what())};
  }
  return report;
}

const char* pass_or_fail(const CaseReport& report) {
  return report.verdict() == Verdict::passed ? "pass" : "FAIL";
}

/// Judges each case when its last run ends, in any thread.
class Judge {
 public:
  Judge(const std::vector<const Case*>& cases, const std::vector<PlannedRun>& runs, Extent extent)
      : runs_(runs), extent_(extent), outcomes_(runs.size()) {
    for (const Case* c : cases) reports_[c] = std::nullopt;
    for (const PlannedRun& run : runs) ++runs_left_[run.owner];
  }

  /// Returns a line about the case after the last of its runs.
  std::string run_ended(std::size_t run, const RunReport& outcome) {
    const Case* c = runs_[run].owner;
    {
      const std::lock_guard lock(mutex_);
      outcomes_[run] = outcome;
      if (--runs_left_.at(c) > 0) return "";
    }
    reports_.at(c) = judge(*c, runs_, outcomes_, extent_);
    return fmt::format("{}: {}", c->name, pass_or_fail(*reports_.at(c)));
  }

  /// Reports of the judged cases, in the order of the cases.
  std::vector<CaseReport> reports(const std::vector<const Case*>& cases) const {
    std::vector<CaseReport> found;
    for (const Case* c : cases) {
      if (reports_.at(c)) found.push_back(*reports_.at(c));
    }
    return found;
  }

 private:
  const std::vector<PlannedRun>& runs_;
  Extent extent_;
  std::mutex mutex_;  ///< guards the two below
  std::vector<RunReport> outcomes_;
  std::map<const Case*, int> runs_left_;
  std::map<const Case*, std::optional<CaseReport>> reports_;
};

void print_tables(const std::vector<CaseReport>& reports) {
  for (const CaseReport& report : reports) {
    fmt::print("{}: {}\n{}", report.verification_case->name, pass_or_fail(report),
               check_table(report));
  }
  std::cout << std::flush;
}

void write_page(const std::vector<CaseReport>& reports, const Campaign& campaign,
                const fs::path& page) {
  fs::create_directories(fs::absolute(page).parent_path());
  const std::string trouble =
      draw_figures(reports, campaign.directory, page.parent_path() / "figures");
  std::ofstream(page) << verification_page(reports, campaign.extent);
  const fs::path html = campaign.directory / "verification.html";
  const std::string html_trouble = write_html(page, html);
  if (!trouble.empty()) fmt::print(stderr, "figures are missing: {}\n", trouble);
  if (!html_trouble.empty()) fmt::print(stderr, "{} is missing: {}\n", html.string(), html_trouble);
  fmt::print(stderr, "the page is {}{}\n", page.string(),
             html_trouble.empty() ? " and, for a browser, " + html.string() : "");
}

}  // namespace

int verify(const VerifyOptions& options) {
  const Extent extent = options.quick ? Extent::quick : Extent::full;
  const fs::path standard = options.quick ? "runs/verification-quick" : "runs/verification";
  const Campaign campaign{options.out.empty() ? standard : options.out, extent, options.threads,
                          options.quiet};
  const auto chosen = chosen_cases(options.cases);
  const auto runs = plan(chosen, campaign);
  print_plan(chosen, runs);
  if (options.list) return exit_ok;
  fs::create_directories(campaign.directory);
  Judge judge(chosen, runs, extent);
  try {
    carry_out(runs, campaign, [&](std::size_t run, const RunReport& outcome) {
      return judge.run_ended(run, outcome);
    });
  } catch (const Interrupted&) {
    print_tables(judge.reports(chosen));
    fmt::print(stderr, "stopped; the same command continues from here\n");
    return exit_interrupted;
  }
  const std::vector<CaseReport> reports = judge.reports(chosen);
  print_tables(reports);
  write_page(reports, campaign,
             options.page.empty() ? campaign.directory / "verification.md" : options.page);
  const auto failed = std::count_if(reports.begin(), reports.end(), [](const CaseReport& report) {
    return report.verdict() == Verdict::failed;
  });
  fmt::print("{} of {} cases passed\n", reports.size() - failed, reports.size());
  return failed == 0 ? exit_ok : exit_not_verified;
}

}  // namespace zona::studies
