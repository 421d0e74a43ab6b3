#include "studies/verification/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>

#include "studies/input/nearest.h"
#include "studies/program/commands.h"
#include "studies/run/interrupt.h"
#include "studies/run/progress.h"
#include "studies/verification/campaign.h"
#include "studies/verification/page.h"

namespace zona::studies {

namespace fs = std::filesystem;
using namespace verification;

namespace {

/// Point-steps a second that two cores of an ordinary machine reach; only the forecast uses it.
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
  fmt::print(stderr, "in all {} on two ordinary cores; Ctrl-C stops, the same command goes on\n",
             forecast(todo));
}

Check failed_run(const std::string& label, const std::string& message) {
  return {"run " + label, "none", "", "", "complete", message, Verdict::failed};
}

/// Computes what a case still lacks and compares; nothing when the user stopped it.
CaseReport compute_case(const Case& c, const std::vector<PlannedRun>& runs,
                        const Campaign& campaign, int& position) {
  CaseReport report{&c, {}, {}, {}};
  CaseResults results;
  for (const PlannedRun& run : runs) {
    if (run.owner != &c) continue;
    ++position;
    if (!run.is_done && !campaign.quiet) {
      fmt::print(stderr, "[{}/{}] {}, {}\n", position, runs.size(), c.name, run.run.label);
    }
    const RunReport outcome = carry_out(run, campaign);
    if (outcome.status != "complete") {
      report.evaluation.checks.push_back(failed_run(run.run.label, outcome.message));
      continue;
    }
    RunResults found(run.directory);
    report.runs.push_back(run.run);
    report.wall_seconds.push_back(found.wall_seconds());
    results.add(run.run.label, std::move(found));
  }
  if (!report.evaluation.checks.empty()) return report;
  try {
    report.evaluation = c.evaluate(results, campaign.extent);
  } catch (const std::exception& error) {
    report.evaluation.checks = {failed_run("evaluation", error.what())};
  }
  return report;
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
  std::vector<CaseReport> reports;
  int position = 0;
  bool all_passed = true;
  try {
    for (const Case* c : chosen) {
      reports.push_back(compute_case(*c, runs, campaign, position));
      const bool passed = reports.back().verdict() == Verdict::passed;
      all_passed = all_passed && passed;
      fmt::print("{}: {}\n{}", c->name, passed ? "pass" : "FAIL", check_table(reports.back()));
      std::cout << std::flush;
    }
  } catch (const Interrupted&) {
    fmt::print(stderr, "stopped; the same command goes on from here\n");
    return exit_interrupted;
  }
  write_page(reports, campaign,
             options.page.empty() ? campaign.directory / "verification.md" : options.page);
  const auto failed = std::count_if(reports.begin(), reports.end(), [](const CaseReport& report) {
    return report.verdict() == Verdict::failed;
  });
  fmt::print("{} of {} cases passed\n", reports.size() - failed, reports.size());
  return all_passed ? exit_ok : exit_not_verified;
}

}  // namespace zona::studies
