#include "studies/simulation/checkpoints.h"

#include <fmt/format.h>

#include <algorithm>

#include "mpm/step/instruction_set.h"
#include "studies/parameters/run_table.h"
#include "studies/run/resolved_study.h"
#include "studies/run/version.h"

namespace zona::studies {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = "checkpoint-";
constexpr std::size_t kept = 2;

bool is_checkpoint(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.rfind(prefix, 0) == 0 && (file.extension() == ".h5" || file.extension() == ".tmp");
}

/// Checkpoints with this extension (.h5: written, .tmp: unfinished), the newest first.
std::vector<fs::path> checkpoints_in(const fs::path& directory, const char* extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (is_checkpoint(entry.path()) && entry.path().extension() == extension)
      files.push_back(entry.path());
  }
  std::sort(files.rbegin(), files.rend());
  return files;
}

std::string label(const mpm::CheckpointLabels& labels, const char* name) {
  const auto found = labels.find(name);
  return found == labels.end() ? std::string() : found->second;
}

void check_labels(const fs::path& file, const mpm::CheckpointLabels& labels,
                  const std::string& study) {
  if (label(labels, "version") != zona_version()) {
    throw mpm::CheckpointError(fmt::format("{}: is of zona {}, this is {}; go on with that version",
                                           file.string(), label(labels, "version"),
                                           zona_version()));
  }
  if (label(labels, "study") != study) {
    throw mpm::CheckpointError(
        fmt::format("{}: is of another study; go on with the study file "
                    "that the run was started with",
                    file.string()));
  }
}

}  // namespace

CheckpointPlan checkpoint_plan(const Configuration& study, bool resume) {
  CheckpointPlan plan;
  const auto intervals = study.read<CheckpointIntervals>();
  plan.interval = intervals.checkpoint_interval;
  plan.steps = intervals.checkpoint_steps;
  plan.study = study_fingerprint(study);
  plan.resume = resume;
  return plan;
}

Checkpoints::Checkpoints(fs::path directory, CheckpointPlan plan)
    : directory_(std::move(directory)), plan_(std::move(plan)) {
  if (plan_.resume) find_start();
}

void Checkpoints::find_start() {
  const auto files = checkpoints_in(directory_, ".h5");
  for (const fs::path& file : files) {
    std::optional<mpm::Checkpoint> whole;
    try {
      whole.emplace(file.string());
    } catch (const std::runtime_error& error) {
      warning_ += fmt::format("{}{}", warning_.empty() ? "left aside: " : "; ", error.what());
      continue;
    }
    check_labels(file, whole->labels(), plan_.study);
    const std::string processor = label(whole->labels(), "processor");
    if (processor != mpm::instruction_set()) {
      warning_ += fmt::format(
          "{}stored on a processor with {}, this one has {}: the last bits of "
          "the results may differ",
          warning_.empty() ? "" : "; ", processor, mpm::instruction_set());
    }
    start_ = std::move(whole);
    last_step_ = std::stoll(file.stem().string().substr(prefix.size()));
    return;
  }
  if (!files.empty()) {
    throw mpm::CheckpointError(
        fmt::format("no checkpoint is whole; {}; delete the directory to start anew", warning_));
  }
}

bool Checkpoints::is_due(std::int64_t step) const {
  if (step == last_step_) return false;
  if (plan_.steps > 0 && step % plan_.steps == 0) return true;
  const std::chrono::duration<double> waited = Clock::now() - last_time_;
  return plan_.interval > 0 && waited.count() >= plan_.interval;
}

bool Checkpoints::store(std::int64_t step, const mpm::VisitState& visit) {
  if (step == last_step_ && is_resumed()) return false;
  mpm::write_checkpoint(
      (directory_ / fmt::format("{}{:012}.h5", prefix, step)).string(),
      {{"version", zona_version()}, {"study", plan_.study}, {"processor", mpm::instruction_set()}},
      visit);
  last_step_ = step;
  last_time_ = Clock::now();
  const auto files = checkpoints_in(directory_, ".h5");
  std::error_code ignored;
  for (std::size_t f = kept; f < files.size(); ++f) fs::remove(files[f], ignored);
  for (const fs::path& unfinished : checkpoints_in(directory_, ".tmp"))
    fs::remove(unfinished, ignored);
  return true;
}

void remove_checkpoints(const fs::path& directory) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(directory, ignored)) {
    if (is_checkpoint(entry.path())) files.push_back(entry.path());
  }
  for (const fs::path& file : files) fs::remove(file, ignored);
}

}  // namespace zona::studies
