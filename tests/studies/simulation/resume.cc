#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "studies/run/file_lock.h"
#include "studies/simulation/checkpoints.h"
#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const std::string studies = ZONA_SOURCE_DIR "/studies/";

/// A small lateral piercing with points failing.
std::string piercing_until(const std::string& end) {
  return studies +
         "piercing_lateral_quick.toml --set 'grid.cell=\"12 um\"' --set 'grid.domain=\"168 um\"'"
         " --set zona.level=4 --set zona.elastic_limit=0.002 --set cytoplasm.points_per_cell=1"
         " --set 'output.fields_interval=\"1 us\"' --set 'time.end=\"" +
         end + "\"'";
}

/// So short that it takes half a second.
const std::string piercing = piercing_until("6 us");
const std::string comparison =
    studies +
    "mercury_vs_water.toml --set 'grid.cell=\"12 um\"' --set 'grid.domain=\"168 um\"'"
    " --set zona.level=4 --set cytoplasm.points_per_cell=1 --set 'time.end=\"4 us\"'"
    " --set 'output.fields_interval=\"2 us\"' --set 'fill.fluids=[\"mercury\", \"water\", "
    "\"none\"]'";

/// A ball of a plastic solid dropped on the floor, with everything that a scene keeps of its past.
const std::string scene = R"(
study = "scene"
[grid]
low = ["0 m", "0 m", "0 m"]
high = ["1 m", "1 m", "1 m"]
cell = "0.1 m"
[boundary]
z_low = "fixed"
[gravity]
acceleration = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[[body]]
name = "ball"
shape = "sphere"
center = ["0.5 m", "0.5 m", "0.35 m"]
radius = "0.25 m"
material = "solid"
law = "von_mises"
density = "1000 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
yield_strength = "1 kPa"
velocity = ["0", "0", "-1 m/s"]
points_per_cell = 2
[[probe]]
name = "middle"
body = "ball"
kind = "point"
place = ["0.5 m", "0.5 m", "0.35 m"]
quantities = ["position", "stress"]
[[profile]]
name = "p"
axis = "z"
cells = 1
times = ["10 ms", "50 ms", "100 ms"]
[[section]]
name = "s"
place = "0.5 m"
times = ["20 ms", "90 ms"]
[time]
end = "100 ms"
courant = 0.05
)";

bool has_checkpoint(const fs::path& directory) {
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(directory, ignored)) {
    if (entry.path().filename().string().rfind("checkpoint-", 0) == 0 &&
        entry.path().extension() == ".h5")
      return true;
  }
  return false;
}

/// Runs the program, sends it a signal once it has stored a checkpoint, or `delay` [s] later;
/// whether it was still running.
bool run_and_signal(const std::string& arguments, const fs::path& directory, int signal,
                    double delay = 0) {
  const std::string command = std::string("exec ") + ZONA_PROGRAM " " + arguments + " 2>/dev/null";
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  bool ended = false;
  while (!ended && !has_checkpoint(directory)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ended = waitpid(child, &status, WNOHANG) == child;
  }
  std::this_thread::sleep_for(std::chrono::duration<double>(delay));
  if (!ended) {
    kill(child, signal);
    waitpid(child, &status, 0);
  }
  return signal == SIGKILL ? WIFSIGNALED(status) : WEXITSTATUS(status) == 130;
}

/// All files of two runs are the same, but for what tells of time and place.
void check_same_files(const fs::path& a, const fs::path& b) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(a)) {
    const fs::path name = fs::relative(entry.path(), a);
    if (!entry.is_regular_file() || name == "log.txt" || name == "summary.json" ||
        name == "study.toml" || name == "comparison.txt")
      continue;
    INFO(name);
    REQUIRE(fs::exists(b / name));
    CHECK((read_text(entry.path()) == read_text(b / name)));
    ++files;
  }
  CHECK(files > 3);
  CHECK_FALSE(has_checkpoint(a));
  CHECK_FALSE(has_checkpoint(b));
}

nlohmann::json summary_in(const fs::path& directory) {
  return nlohmann::json::parse(read_text(directory / "summary.json"));
}

void remove_costs(nlohmann::json& results) {
  if (results.is_array()) {
    for (auto& entry : results) remove_costs(entry);
    return;
  }
  for (const char* cost :
       {"output_seconds", "wall_seconds", "point_steps_per_second", "peak_memory_bytes"})
    results.erase(cost);
}

nlohmann::json results_of(const fs::path& directory) {
  auto results = summary_in(directory)["results"];
  remove_costs(results);
  return results;
}

}  // namespace

TEST_CASE("a run that is killed repeatedly gives the same bits") {
  const ScratchDirectory scratch;
  std::string study = piercing;
  int kills = 3;
  SECTION("a piercing") {}
  SECTION("a piercing with implicit pressure") {
    study =
        piercing_until("40 us") + " --set 'numerics.pressure=\"implicit\"' --set time.travel=0.01";
  }
  SECTION("a comparison") {
    study = comparison;
    kills = 4;
  }
  SECTION("a scene") {
    study = scratch.write("scene.toml", scene).string();
  }
  const auto whole = scratch.path() / "whole", cut = scratch.path() / "cut";
  const auto answer = call("run " + study + " --quiet --out " + whole.string());
  INFO(answer.text);
  REQUIRE(answer.code == 0);
  const std::string settings = " --set run.checkpoint_steps=7 --out " + cut.string();
  std::mt19937 random(3);
  int killed = run_and_signal("run " + study + settings, cut, SIGKILL) ? 1 : 0;
  for (int i = 1; i < kills; ++i) {
    const std::string threads = " --threads " + std::to_string(1 + i % 3);
    const double delay = 0.05 + 0.2 * static_cast<double>(random() % 1000) / 1000;
    if (run_and_signal("run " + cut.string() + " --resume" + threads, cut, SIGKILL, delay))
      ++killed;
  }
  CHECK(killed > 0);
  const auto end = call("run " + study + settings + " --resume --quiet --threads 3");
  INFO(end.text);
  REQUIRE(end.code == 0);
  check_same_files(whole, cut);
  CHECK(results_of(whole) == results_of(cut));
}

TEST_CASE("an interrupted run stores its state and continues to the same bits") {
  const ScratchDirectory scratch;
  const auto whole = scratch.path() / "whole", cut = scratch.path() / "cut";
  REQUIRE(call("run " + piercing + " --quiet --out " + whole.string()).code == 0);
  const std::string run = "run " + piercing + " --out " + cut.string();
  REQUIRE(run_and_signal(run + " --set run.checkpoint_steps=90", cut, SIGTERM));
  CHECK(summary_in(cut)["status"] == "interrupted");
  // A row and a frame of the instant of the stop are there to look at, and go.
  const auto end = call(run + " --resume");
  CHECK(end.code == 0);
  CHECK_THAT(end.text, Contains("goes on after"));
  check_same_files(whole, cut);
  const auto again = call(run + " --resume");
  CHECK(again.code == 0);
  CHECK_THAT(again.text, Contains("is complete"));
}

TEST_CASE("zona status reports a run from outside") {
  const ScratchDirectory scratch;
  const auto cut = scratch.path() / "cut";
  const auto status = [&] { return call("status " + cut.string()); };
  CHECK(status().code == 2);
  CHECK_THAT(status().text, Contains("holds no run"));
  const std::string run = "run " + piercing + " --out " + cut.string();
  REQUIRE(run_and_signal(run + " --set run.checkpoint_steps=20", cut, SIGKILL));
  CHECK_THAT(status().text, Contains("killed") && Contains("--resume"));
  {
    const FileLock lock(cut / "log.txt");
    std::ofstream(cut / "status.json") << R"({"progress": "piercing 12 %", "updated": 5})";
    CHECK_THAT(status().text, Contains("running\npiercing 12 %") && Contains(" ago"));
  }
  CHECK_THAT(status().text, Contains("killed") && Contains("piercing 12 %"));
  REQUIRE(call(run + " --resume").code == 0);
  CHECK(status().text == "complete\n");
}

TEST_CASE("runs that cannot be resumed are refused with the reason and lose nothing") {
  const ScratchDirectory scratch;
  const auto cut = scratch.path() / "cut";
  const std::string piercing = piercing_until("12 us");
  const std::string run = "run " + piercing + " --out " + cut.string();
  REQUIRE(run_and_signal(run + " --set run.checkpoint_steps=50", cut, SIGTERM, 0.2));
  const auto refused = [&](const std::string& arguments, int code, const std::string& reason) {
    const auto answer = call(arguments);
    CHECK(answer.code == code);
    CHECK_THAT(answer.text, Contains(reason));
  };
  refused("run " + piercing + " --resume --out " + (scratch.path() / "none").string(), 2,
          "holds no run that could go on");
  refused(run, 2, "is there already");
  refused(run + " --resume --set 'zona.density=\"1000 kg/m^3\"'", 2, "zona.density was");
  {
    const FileLock lock(cut / "log.txt");
    REQUIRE(lock.is_held());
    refused(run + " --resume", 2, "is being computed by another process");
  }
  std::vector<fs::path> checkpoints;
  for (const auto& entry : fs::directory_iterator(cut)) {
    if (entry.path().filename().string().rfind("checkpoint-", 0) == 0)
      checkpoints.push_back(entry.path());
  }
  REQUIRE(checkpoints.size() == 2);
  std::sort(checkpoints.begin(), checkpoints.end());
  fs::resize_file(checkpoints[1], fs::file_size(checkpoints[1]) / 2);
  const std::string older = read_text(checkpoints[0]);
  std::string damaged = older;
  damaged[damaged.size() / 3] ^= 4;
  std::ofstream(checkpoints[0], std::ios::binary) << damaged;
  const std::string summary = read_text(cut / "summary.json");
  refused(run + " --resume", 2, "no checkpoint is whole");
  CHECK(read_text(cut / "summary.json") == summary);
  std::ofstream(checkpoints[0], std::ios::binary) << older;
  const auto end = call(run + " --resume");  // from the older one
  CHECK(end.code == 0);
  CHECK_THAT(end.text, Contains("left aside") && Contains("is damaged"));
}

TEST_CASE("checkpoints of another study or version are refused") {
  const ScratchDirectory scratch;
  double state = 1;
  const auto visit = [&](zona::mpm::StateVisitor& visitor) { visitor.visit("state", state); };
  CheckpointPlan plan;
  plan.study = "one";
  for (int step : {10, 20, 30}) Checkpoints(scratch.path(), plan).store(step, visit);
  plan.resume = true;
  state = 0;
  Checkpoints(scratch.path(), plan).restore(visit);
  CHECK(state == 1);
  CHECK(std::distance(fs::directory_iterator(scratch.path()), {}) == 2);
  plan.study = "two";
  CHECK_THROWS_WITH(Checkpoints(scratch.path(), plan), Contains("of another study"));
  zona::mpm::write_checkpoint((scratch.path() / "checkpoint-000000000040.h5").string(),
                              {{"version", "0.0.0"}, {"study", "two"}}, visit);
  CHECK_THROWS_WITH(Checkpoints(scratch.path(), plan), Contains("is of zona 0.0.0"));
}
