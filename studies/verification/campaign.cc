#include "studies/verification/campaign.h"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "studies/kinds/study_kinds.h"
#include "studies/program/bundled_studies.h"
#include "studies/program/commands.h"
#include "studies/run/resolved_study.h"
#include "studies/run/run_directory.h"
#include "studies/run/version.h"

namespace zona::studies::verification {

namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_done(const Configuration& study, const fs::path& directory) {
  if (content(directory / "study.toml") != resolved_study(study)) return false;
  const auto summary = nlohmann::json::parse(content(directory / "summary.json"), nullptr, false);
  return summary.is_object() && summary.value("status", "") == "complete" &&
         summary.value("zona", "") == zona_version();
}

double point_steps(const Configuration& study) {
  const StudyKind& kind = find_study_kind(study.kind());
  return kind.estimate ? kind.estimate(study).point_steps : 0;
}

}  // namespace

std::vector<PlannedRun> plan(const std::vector<const Case*>& cases, const Campaign& campaign) {
  std::vector<PlannedRun> runs;
  std::vector<Problem> problems;
  for (const Case* verification_case : cases) {
    for (const Run& run : verification_case->runs(campaign.extent)) {
      const fs::path directory = campaign.directory / verification_case->name / run.label;
      try {
        const Configuration study = load_configuration(study_directory() / run.file, run.overrides);
        find_study_kind(study.kind()).prepare(study);
        const bool done = is_done(study, directory);
        runs.push_back({verification_case, run, study, directory, point_steps(study), done});
      } catch (const InputError& error) {
        problems.insert(problems.end(), error.problems().begin(), error.problems().end());
      }
    }
  }
  if (!problems.empty()) throw InputError(problems);
  return runs;
}

RunReport carry_out(const PlannedRun& run, const Campaign& campaign) {
  if (run.is_done) return {"complete", ""};
  fs::remove_all(run.directory);
  RunDirectory directory = RunDirectory::named(run.directory);
  const RunOutcome outcome = compute_study(run.study, find_study_kind(run.study.kind()), directory,
                                           {campaign.threads, campaign.quiet});
  if (outcome.status == "interrupted") throw Interrupted{};
  return {outcome.status, outcome.message};
}

}  // namespace zona::studies::verification
