#include "studies/verification/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "studies/program/bundled_studies.h"
#include "studies/program/python_script.h"
#include "studies/run/progress.h"
#include "studies/run/version.h"

namespace zona::studies::verification {

namespace fs = std::filesystem;

namespace {

std::string or_dash(const std::string& text) {
  return text.empty() ? "-" : text;
}

/// Keeps a text in its cell of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return text;
}

int count(const std::vector<CaseReport>& reports, Verdict verdict) {
  return static_cast<int>(
      std::count_if(reports.begin(), reports.end(),
                    [&](const CaseReport& report) { return report.verdict() == verdict; }));
}

double cost(const CaseReport& report) {
  double seconds = 0;
  for (const double wall : report.wall_seconds) seconds += wall;
  return seconds;
}

/// The checks that have an error, an order or a limit, in short.
std::string headline(const CaseReport& report) {
  std::string text;
  for (const Check& check : report.evaluation.checks) {
    if (check.verdict == Verdict::reported) continue;
    const std::string figure =
        check.error.empty() || check.quantity.rfind("order", 0) == 0 ? check.value : check.error;
    text += fmt::format("{}{}: {}{}", text.empty() ? "" : "<br>", check.quantity, figure,
                        check.verdict == Verdict::failed ? " **FAIL**" : "");
  }
  return or_dash(text);
}

std::string overview(const std::vector<CaseReport>& reports) {
  std::string text =
      "| Case | Source | Reference | Errors and orders | Verdict |\n"
      "| --- | --- | --- | --- | --- |\n";
  for (const CaseReport& report : reports) {
    const Case& c = *report.verification_case;
    text +=
        fmt::format("| [{}](#{}) | {} | {} | {} | {} |\n", c.title, c.name, cell(or_dash(c.source)),
                    cell(c.reference), cell(headline(report)), word(report.verdict()));
  }
  return text;
}

std::string command(const Run& run) {
  std::string text = "zona run studies/" + run.file;
  for (const std::string& override_text : run.overrides) {
    text += fmt::format(" --set '{}'", override_text);
  }
  return text;
}

std::string runs_text(const CaseReport& report) {
  std::string text =
      "<details><summary>Runs</summary>\n\n| Run | Command | Time |\n| --- | --- | --: |\n";
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    text += fmt::format("| {} | `{}` | {} |\n", report.runs[i].label, cell(command(report.runs[i])),
                        duration_text(report.wall_seconds[i]));
  }
  return text + "\n</details>\n";
}

std::string checks_text(const CaseReport& report) {
  std::string text =
      "| Quantity | Value | Reference | Error | Limit | Verdict | Origin of the limit, or meaning "
      "|\n| --- | --: | --: | --: | --: | --- | --- |\n";
  for (const Check& check : report.evaluation.checks) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", cell(check.quantity), check.value,
                        cell(or_dash(check.reference)), or_dash(check.error), or_dash(check.limit),
                        word(check.verdict), cell(check.origin));
  }
  return text;
}

std::string section(const CaseReport& report) {
  const Case& c = *report.verification_case;
  std::string text = fmt::format("\n<a id=\"{}\"></a>\n\n## {}\n\n", c.name, c.title);
  if (!c.source.empty()) text += fmt::format("Source: {}. ", c.source);
  text += fmt::format("Compared with: {}.\n\n{}", c.reference, checks_text(report));
  for (const Figure& figure : report.evaluation.figures) {
    for (const std::string& file : figure.files(c.name)) {
      text += fmt::format("\n![{}](figures/{})\n", figure.caption, file);
    }
    text += fmt::format("\n*{}*\n", figure.caption);
  }
  for (const std::string& remark : report.evaluation.remarks) text += "\n- " + remark;
  return text + (report.evaluation.remarks.empty() ? "\n" : "\n\n") + runs_text(report);
}

/// Runs one of the project's scripts; returns "" or the end of its error output.
std::string run_figure_script(const std::string& script, const std::vector<fs::path>& arguments) {
  const ScriptOutcome outcome = run_script(report_directory() / script, arguments);
  return outcome.succeeded ? "" : end_of(outcome.output);
}

}  // namespace

std::string verification_page(const std::vector<CaseReport>& reports, Extent extent) {
  double seconds = 0;
  for (const CaseReport& report : reports) seconds += cost(report);
  std::string text = fmt::format(
      "# Verification\n\nWritten by `zona verify{}` of zona {} ({}); do not edit. {} cases: {} "
      "passed, {} failed. All runs together took {}.\n\nEvery case is a study file that can be "
      "copied and changed; a case only compares what its runs wrote with its reference. \"The "
      "source\" is the dissertation whose equation, table and figure numbers are quoted. "
      "\"reported\" "
      "has no limit.\n\n",
      extent == Extent::quick ? " --quick" : "", zona_version(), compiler_version(), reports.size(),
      count(reports, Verdict::passed), count(reports, Verdict::failed), duration_text(seconds));
  text += overview(reports);
  for (const CaseReport& report : reports) text += section(report);
  return text;
}

std::string check_table(const CaseReport& report) {
  std::string text;
  for (const Check& check : report.evaluation.checks) {
    text +=
        fmt::format("  {:<5} {:<52} {:>11}  {:<14} {:>9} {}\n", word(check.verdict), check.quantity,
                    check.value, check.reference.empty() ? "" : "of " + check.reference,
                    check.error.size() < 16 ? check.error : "",
                    check.limit.empty() ? "" : "(" + check.limit + ")");
  }
  return text;
}

std::string draw_figures(const std::vector<CaseReport>& reports, const fs::path& campaign_directory,
                         const fs::path& folder) {
  nlohmann::json all = nlohmann::json::array();
  for (const CaseReport& report : reports) {
    for (const Figure& figure : report.evaluation.figures) {
      nlohmann::json entry = to_json(figure);
      entry["files"] = figure.files(report.verification_case->name);
      entry["runs"] = (campaign_directory / report.verification_case->name).string();
      all.push_back(std::move(entry));
    }
  }
  fs::create_directories(folder);
  const fs::path description = campaign_directory / "figures.json";
  std::ofstream(description) << all.dump();
  return run_figure_script("draw_verification.py", {description, folder});
}

std::string write_html(const fs::path& markdown, const fs::path& html) {
  return run_figure_script("page_to_html.py", {markdown, html});
}

}  // namespace zona::studies::verification
