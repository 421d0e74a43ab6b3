#include "studies/kinds/search/case_store.h"

#include <fmt/format.h>
#include <omp.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <exception>
#include <fstream>
#include <mutex>
#include <thread>

#include "mpm/files/atomic_file.h"
#include "mpm/points/errors.h"
#include "studies/kinds/piercing/run.h"
#include "studies/kinds/piercing/values.h"
#include "studies/parameters/beam_parameters.h"
#include "studies/run/file_lock.h"
#include "studies/run/interrupt.h"
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

/// What the threads of a stage share: the numbers of the piercings that nobody has begun.
class Queue {
 public:
  explicit Queue(std::deque<std::size_t> numbers) : numbers_(std::move(numbers)) {}

  std::optional<std::size_t> next() {
    const std::lock_guard lock(mutex_);
    if (numbers_.empty() || failure_) return std::nullopt;
    const std::size_t number = numbers_.front();
    numbers_.pop_front();
    return number;
  }

  void put_back(std::size_t number) {
    const std::lock_guard lock(mutex_);
    numbers_.push_back(number);
  }

  void fail(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::deque<std::size_t> numbers_;
  std::exception_ptr failure_;
};

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
  } catch (const mpm::PointError& error) {
    results["failure"] = error.what();
    log->error(error.what());
  }
  if (Interrupt::requested() && !results.contains("failure")) return State::interrupted;
  mpm::replace_file((folder / "results.json").string(), results.dump(1) + "\n");
  remove_checkpoints(folder);
  return State::complete;
}

std::vector<json> CaseStore::run(const std::vector<Configuration>& piercings,
                                 const std::string& label, Session& session) const {
  const int count = static_cast<int>(piercings.size());
  std::vector<json> results(piercings.size());
  std::deque<std::size_t> waiting;
  double longest = 0;
  for (const Configuration& piercing : piercings)
    longest = std::max(longest, simulation_end(piercing));
  session.progress.start(label, longest, std::max(count, 1));
  for (std::size_t i = 0; i < piercings.size(); ++i) {
    results[i] = result(piercings[i]);
    if (results[i].is_null()) {
      waiting.push_back(i);
    } else {
      session.progress.begin_at(longest, 0, static_cast<int>(i));
    }
  }
  const int workers = std::min<int>(session.threads, static_cast<int>(waiting.size()));
  Queue queue(std::move(waiting));
  const auto work = [&](int threads) {
    omp_set_num_threads(threads);
    while (const auto number = queue.next()) {
      const int part = static_cast<int>(*number);
      try {
        const State state = Interrupt::requested()
                                ? State::interrupted
                                : compute(piercings[*number], threads, part, session);
        if (state == State::complete) {
          const json& r = results[*number] = result(piercings[*number]);
          const double done = r.value("points", 0.) * r.value("steps", 0.);
          session.progress.update(longest, done, "", part);
        } else if (state == State::busy) {
          queue.put_back(*number);
          std::this_thread::sleep_for(std::chrono::seconds(1));
        }
      } catch (...) {
        queue.fail(std::current_exception());
      }
    }
  };
  std::vector<std::thread> pool;
  for (int w = 0; w < workers; ++w) pool.emplace_back(work, std::max(1, session.threads / workers));
  for (std::thread& thread : pool) thread.join();
  session.progress.finish();
  queue.rethrow();
  return results;
}

}  // namespace zona::studies::search
