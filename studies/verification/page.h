#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/verification/evaluation/verification_case.h"

namespace zona::studies::verification {

/// A case with all that the page shows.
struct CaseReport {
  const Case* verification_case;
  std::vector<Run> runs;
  std::vector<double> wall_seconds;  ///< of each run
  Evaluation evaluation;
  Verdict verdict() const { return verdict_of(evaluation.checks); }
};

/// The verification page as Markdown; figures are expected in `figures` beside it.
std::string verification_page(const std::vector<CaseReport>& reports, Extent extent);

/// A table for the terminal: one line per check, failed ones marked.
std::string check_table(const CaseReport& report);

/// Draws the figures of all cases into `folder` with matplotlib. Returns an empty text, or why
/// figures are missing; the page does not need them.
std::string draw_figures(const std::vector<CaseReport>& reports,
                         const std::filesystem::path& campaign_directory,
                         const std::filesystem::path& folder);

/// Turns the Markdown page into one self-contained HTML file. Returns what is missing, or "".
std::string write_html(const std::filesystem::path& markdown, const std::filesystem::path& html);

}  // namespace zona::studies::verification
