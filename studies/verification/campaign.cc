#include "studies/verification/campaign.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <fstream>
#include <iostream>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>

#include "studies/kinds/study_kinds.h"
#include "studies/program/bundled_studies.h"
#include "studies/program/compute_study.h"
#include "studies/run/interrupt.h"
#include "studies/run/parallel.h"
#include "studies/run/progress.h"
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

/// Work of a run without an estimate, e.g. a vibration, which takes seconds [point-steps].
constexpr double unknown_work = 3e7;

double work_of(const PlannedRun& run) {
  return run.point_steps > 0 ? run.point_steps : unknown_work;
}

/// Pool of threads for runs.
class FreeThreads {
 public:
  explicit FreeThreads(int count) : count_(count) {}

  /// Holds threads of the pool while it lives.
  class Taken {
   public:
    /// Waits until enough threads are free.
    Taken(FreeThreads& from, int count) : from_(from), taken_(count) {
      std::unique_lock lock(from_.mutex_);
      from_.changed_.wait(lock, [&] { return from_.count_ >= taken_; });
      from_.count_ -= taken_;
    }
    ~Taken() {
      const std::lock_guard lock(from_.mutex_);
      from_.count_ += taken_;
      from_.changed_.notify_all();
    }
    Taken(const Taken&) = delete;
    Taken& operator=(const Taken&) = delete;

   private:
    FreeThreads& from_;
    int taken_;
  };

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int count_;
};

/// The runs of a campaign while they are computed.
class SideBySide {
 public:
  SideBySide(const std::vector<PlannedRun>& runs, const Campaign& campaign,
             const RunEnded& run_ended)
      : runs_(runs),
        run_ended_(run_ended),
        threads_(campaign.threads > 0 ? campaign.threads : omp_get_num_procs()),
        free_(threads_),
        progress_(Progress::suitable_mode(campaign.quiet), std::cerr) {
    double work = 0;
    for (const PlannedRun& run : runs_) {
      work += work_of(run);
      if (!run.is_done) work_left_ += work_of(run);
    }
    const int count = static_cast<int>(runs_.size());
    progress_.start("verification", work / std::max(count, 1), count);
    for (int i = 0; i < count; ++i) {
      if (runs_[i].is_done) progress_.begin_at(work_of(runs_[i]), 0, i);
    }
  }

  /// Throws a failure after all runs have ended.
  void run() {
    const std::vector<std::size_t> order = longest_first();
    parallel_for(order.size(), {threads_, 1}, [&](std::size_t place) {
      const std::size_t i = order[place];
      const int threads = threads_of(runs_[i]);
      const FreeThreads::Taken taken(free_, threads);
      if (Interrupt::requested()) return;
      omp_set_num_threads(threads);
      const RunReport report = compute(i, threads);
      if (report.status != "interrupted") end(i, report);
    });
    if (!Interrupt::requested()) progress_.finish();
  }

 private:
  std::vector<std::size_t> longest_first() const {
    std::vector<std::size_t> order(runs_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto left = [&](std::size_t i) { return runs_[i].is_done ? 0 : work_of(runs_[i]); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return left(a) > left(b); });
    return order;
  }

  /// Threads in proportion to the remaining work, so that no run ends long after the others.
  int threads_of(const PlannedRun& run) const {
    if (run.is_done) return 1;
    const double share = std::ceil(work_of(run) / work_left_ * threads_ - 1e-9);
    return std::clamp(static_cast<int>(share), 1, std::min(threads_, threads_for(run.study, 0)));
  }

  RunReport compute(std::size_t i, int threads) {
    const PlannedRun& run = runs_[i];
    if (run.is_done) return {"complete", ""};
    const std::string name = run.owner->name + "/" + run.run.label;
    const auto show = [&, furthest = 0.](double fraction) mutable {
      furthest = std::max(furthest, fraction);  // of several stages
      progress_.update(furthest * work_of(run), 0, fmt::format("{} {:.0f} %", name, 100 * furthest),
                       static_cast<int>(i));
    };
    fs::remove_all(run.directory);
    RunDirectory directory = RunDirectory::named(run.directory);
    progress_.update(0, 0, name, static_cast<int>(i));
    const RunOutcome outcome = compute_study(run.study, find_study_kind(run.study.kind()),
                                             directory, {threads, true, false, show});
    return {outcome.status, outcome.message};
  }

  void end(std::size_t i, const RunReport& report) {
    progress_.update(work_of(runs_[i]), 0, "", static_cast<int>(i));
    const std::string line = run_ended_(i, report);
    if (!line.empty()) progress_.say(line);
  }

  const std::vector<PlannedRun>& runs_;
  const RunEnded& run_ended_;
  int threads_;
  double work_left_ = 0;
  FreeThreads free_;
  Progress progress_;
};

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

void carry_out(const std::vector<PlannedRun>& runs, const Campaign& campaign,
               const RunEnded& run_ended) {
  const Interrupt interrupt;
  SideBySide work(runs, campaign, run_ended);
  work.run();
  if (Interrupt::requested()) throw Interrupted{};
}

}  // namespace zona::studies::verification
