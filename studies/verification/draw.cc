#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "studies/bundled_studies.h"
#include "studies/verification/page.h"

namespace zona::studies::verification {

namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// Runs one of the project's Python scripts; returns "" or the end of what it complained about.
std::string run_script(const std::string& script, const std::vector<fs::path>& arguments) {
  std::string line = "/usr/bin/python3 " + quoted((figure_directory() / script).string());
  for (const fs::path& argument : arguments) line += " " + quoted(argument.string());
  std::FILE* pipe = popen((line + " 2>&1").c_str(), "r");
  if (!pipe) return "/usr/bin/python3 cannot be started";
  std::string output;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe)) output += buffer.data();
  if (pclose(pipe) == 0) return "";
  const std::size_t shown = 600;
  return output.size() > shown ? "..." + output.substr(output.size() - shown) : output;
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
  return run_script("draw_verification.py", {description, folder});
}

std::string write_html(const fs::path& markdown, const fs::path& html) {
  return run_script("page_to_html.py", {markdown, html});
}

}  // namespace zona::studies::verification
