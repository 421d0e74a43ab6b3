#include <fstream>
#include <nlohmann/json.hpp>

#include "studies/program/bundled_studies.h"
#include "studies/program/python_script.h"
#include "studies/verification/page.h"

namespace zona::studies::verification {

namespace fs = std::filesystem;

namespace {

/// Runs one of the project's scripts; returns "" or the end of its error output.
std::string run_figure_script(const std::string& script, const std::vector<fs::path>& arguments) {
  const ScriptOutcome outcome = run_script(report_directory() / script, arguments);
  return outcome.succeeded ? "" : end_of(outcome.output);
}

}  // namespace

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
