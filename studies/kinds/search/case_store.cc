#include "studies/kinds/search/case_store.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <fstream>
#include <mutex>
#include <optional>
#include <thread>

#include "mpm/files/atomic_file.h"
#include "mpm/points/errors.h"
#include "studies/kinds/piercing/run.h"
#include "studies/kinds/piercing/scheme_tables.h"
#include "studies/parameters/fill_table.h"
#include "studies/run/file_lock.h"
#include "studies/run/interrupt.h"
#include "studies/run/parallel.h"
#include "studies/run/progress.h"
#include "studies/run/resolved_study.h"
#include "studies/run/run_directory.h"
#include "studies/run/version.h"

namespace zona::studies::search {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json read_json(const fs::path& file) {
  std::ifstream stream(file);
  return stream ? json::parse(stream, nullptr, false) : json();
}

/// Piercings that no thread has begun, by number.
class WaitingPiercings {
 public:
  explicit WaitingPiercings(std::deque<std::size_t> numbers) : numbers_(std::move(numbers)) {}

  std::optional<std::size_t> next() {
    const std::lock_guard lock(mutex_);
    if (numbers_.empty() || is_stopped_) return std::nullopt;
    const std::size_t number = numbers_.front();
    numbers_.pop_front();
    return number;
  }

  void put_back(std::size_t number) {
    const std::lock_guard lock(mutex_);
    numbers_.push_back(number);
  }

  /// Empties the queue.
  void stop() {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }

 private:
  std::mutex mutex_;
  std::deque<std::size_t> numbers_;
  bool is_stopped_ = false;
};

double longest_of(const std::vector<Configuration>& piercings) {
  double longest = 0;
  for (const Configuration& piercing : piercings)
    longest = std::max(longest, simulation_end(piercing));
  return longest;
}

}  // namespace

fs::path CaseStore::folder_of(const Configuration& piercing) const {
  return folder_ / fmt::format("{}-{}", study_fingerprint(piercing), zona_version());
}

json CaseStore::result(const Configuration& piercing) const {
  const json found = read_json(folder_of(piercing) / "results.json");
  return found.is_object() ? found : json();
}

CaseStore::State CaseStore::compute(const Configuration& piercing, int threads, int part,
                                    Session& session) const {
  const fs::path folder = folder_of(piercing);
  std::error_code failure;
  fs::create_directories(folder, failure);
  std::ofstream(folder / "lock", std::ios::app);
  const FileLock lock(folder / "lock");
  if (!lock.is_held()) return State::busy;
  if (!result(piercing).is_null()) return State::complete;
  if (!fs::exists(folder / "study.toml"))
    mpm::replace_file((folder / "study.toml").string(), resolved_study(piercing));

  const PiercingCase setup = make_piercing_case(piercing, fills_of(piercing).front());
  OutputPlan plan = output_plan(piercing, setup.end);
  plan.fields = false;
  const auto log = session.directory.log_of(folder.filename().string());
  json results;
  try {
    run_piercing(setup,
                 {piercing, plan, checkpoint_plan(piercing, true), folder, threads, *log,
                  session.progress, part},
                 results);
  } catch (const mpm::StepError& error) {
    results["failure"] = error.what();
    log->error(error.what());
  }
  if (Interrupt::requested() && !results.contains("failure")) return State::interrupted;
  mpm::replace_file((folder / "results.json").string(), results.dump(1) + "\n");
  remove_checkpoints(folder);
  return State::complete;
}

std::deque<std::size_t> CaseStore::look_up(const std::vector<Configuration>& piercings,
                                           double longest, Progress& progress,
                                           std::vector<json>& results) const {
  std::deque<std::size_t> missing;
  for (std::size_t i = 0; i < piercings.size(); ++i) {
    results[i] = result(piercings[i]);
    if (results[i].is_null()) {
      missing.push_back(i);
    } else {
      progress.begin_at(longest, 0, static_cast<int>(i));
    }
  }
  return missing;
}

std::vector<json> CaseStore::run(const std::vector<Configuration>& piercings,
                                 const std::string& label, Session& session) const {
  const double longest = longest_of(piercings);
  std::vector<json> results(piercings.size());
  session.progress.start(label, longest, std::max(static_cast<int>(piercings.size()), 1));
  std::deque<std::size_t> missing = look_up(piercings, longest, session.progress, results);
  const int workers = std::min<int>(session.threads, static_cast<int>(missing.size()));
  const int threads = workers > 0 ? std::max(1, session.threads / workers) : 1;
  WaitingPiercings waiting(std::move(missing));
  const auto compute_one = [&](std::size_t i) {
    const int part = static_cast<int>(i);
    const State state = compute(piercings[i], threads, part, session);
    if (state == State::complete) {
      const json& r = results[i] = result(piercings[i]);
      session.progress.update(longest, r.value("points", 0.) * r.value("steps", 0.), "", part);
    } else if (state == State::busy) {
      waiting.put_back(i);
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  };
  ParallelLoop loop(workers, {workers, threads}, [&](std::size_t) {
    try {
      while (const auto number = waiting.next()) {
        if (!Interrupt::requested()) compute_one(*number);
      }
    } catch (...) {
      waiting.stop();
      throw;
    }
  });
  loop.join();
  session.progress.finish();
  loop.rethrow();
  return results;
}

}  // namespace zona::studies::search
