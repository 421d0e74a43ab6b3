#include "studies/run/run_directory.h"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "studies/program/exit_code.h"
#include "studies/program/run_study.h"
#include "studies/run/history_file.h"
#include "studies/run/interrupt.h"
#include "studies/run/progress.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// Runs the default vibration with a runner of the test's own; the run directory is `out`.
int run_with(const std::function<void(const Configuration&, Session&)>& runner,
             const fs::path& out) {
  const ScratchDirectory scratch;
  const Configuration study = load_configuration(scratch.write("s.toml", "study = \"vibration\""));
  RunOptions options;
  options.file = study.file();
  options.out = out;
  options.out_given = true;
  options.quiet = true;
  options.threads = 1;
  const Prepare prepare = [&runner](const Configuration& s) -> Job {
    return [&runner, &s](Session& session) { runner(s, session); };
  };
  return run_configuration(study, {&study.schema(), prepare, nullptr, nullptr}, options);
}

nlohmann::json summary_in(const fs::path& directory) {
  return nlohmann::json::parse(read_text(directory / "summary.json"));
}

/// Sends std::cerr elsewhere while it lives.
class QuietErrors {
 public:
  QuietErrors() : old_(std::cerr.rdbuf(caught_.rdbuf())) {}
  ~QuietErrors() { std::cerr.rdbuf(old_); }
  std::string text() const { return caught_.str(); }

 private:
  std::ostringstream caught_;
  std::streambuf* old_;
};

}  // namespace

TEST_CASE("a named run directory must be free") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "a" / "b";
  CHECK(RunDirectory::named(out / "").path() == out);
  CHECK_THROWS_WITH(RunDirectory::named(out), Contains("not an empty directory; delete it"));
  fs::create_directory(scratch.path() / "empty");
  CHECK_NOTHROW(RunDirectory::named(scratch.path() / "empty"));
  scratch.write("file", "");
  CHECK_THROWS_AS(RunDirectory::named(scratch.path() / "file"), InputError);
  CHECK_THROWS_AS(RunDirectory::named(scratch.path() / "file" / "below"), InputError);
  CHECK_THROWS_AS(RunDirectory::named(""), InputError);
  CHECK_THROWS_AS(RunDirectory::named("/proc/zona"), InputError);
}

TEST_CASE("a default run directory takes the next free name") {
  const ScratchDirectory scratch;
  const fs::path before = fs::current_path();
  fs::current_path(scratch.path());
  CHECK(RunDirectory::for_study("x/lateral.toml").path() == "runs/lateral");
  CHECK(RunDirectory::for_study("x/lateral.toml").path() == "runs/lateral-2");
  CHECK(RunDirectory::for_study("lateral.toml").path() == "runs/lateral-3");
  fs::current_path(before);
}

TEST_CASE("files are replaced as a whole") {
  const ScratchDirectory scratch;
  const RunDirectory directory = RunDirectory::named(scratch.path() / "run");
  directory.write("summary.json", "one");
  directory.write("summary.json", "two");
  CHECK(read_text(directory.file("summary.json")) == "two");
  CHECK_FALSE(fs::exists(directory.file("summary.json.partial")));
  CHECK_THROWS_AS(directory.write("no/such/place", ""), RunError);
}

TEST_CASE("a history keeps every digit") {
  const ScratchDirectory scratch;
  const fs::path file = scratch.path() / "history.csv";
  {
    HistoryFile history(file, {{"time", "s"}, {"failed points", ""}});
    history.add({1e-6, 3});
    history.add({0.1 + 0.2, 0});
    CHECK_THROWS_AS(history.add({1}), std::logic_error);
  }
  CHECK(read_text(file) == "time [s],failed points\n1e-06,3\n0.30000000000000004,0\n");
  CHECK_THROWS_AS(HistoryFile(scratch.path() / "no" / "history.csv", {{"time", "s"}}), RunError);
}

TEST_CASE("a run writes its study, log and summary") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "run";
  CHECK(run_with([](const Configuration&, Session& session) { session.results["tip"] = 1.5; },
                 out) == exit_ok);
  const nlohmann::json summary = summary_in(out);
  CHECK(summary["status"] == "complete");
  CHECK(summary["results"]["tip"] == 1.5);
  CHECK(summary["cost"]["threads"] == 1);
  CHECK(summary["zona"].is_string());
  CHECK(summary["compiler"].is_string());
  CHECK(load_configuration(out / "study.toml").kind() == "vibration");
  CHECK_THAT(read_text(out / "log.txt"), Contains("complete after"));
}

TEST_CASE("a failed run keeps what it computed") {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "run";
  const QuietErrors errors;
  const auto fail = [](const Configuration&, Session& session) {
    session.results["last_step"] = 7;
    throw RunError("point 12 left the grid");
  };
  CHECK(run_with(fail, out) == exit_failed);
  CHECK_THAT(errors.text(), Contains("point 12 left the grid"));
  CHECK(summary_in(out)["status"] == "failed");
  CHECK(summary_in(out)["message"] == "point 12 left the grid");
  CHECK(summary_in(out)["results"]["last_step"] == 7);
}

TEST_CASE("an interrupted run keeps its results") {
  const ScratchDirectory scratch;
  const auto interrupted = [](const Configuration&, Session& session) {
    CHECK_FALSE(Interrupt::requested());
    raise(SIGINT);
    if (Interrupt::requested()) session.results["stopped"] = true;
  };
  CHECK(run_with(interrupted, scratch.path() / "run") == exit_interrupted);
  CHECK(summary_in(scratch.path() / "run")["status"] == "interrupted");
  CHECK(summary_in(scratch.path() / "run")["results"]["stopped"] == true);
}

TEST_CASE("a second Ctrl-C ends the program at once") {
  const pid_t child = fork();
  if (child == 0) {
    const Interrupt interrupt;
    raise(SIGINT);
    if (Interrupt::requested()) raise(SIGINT);
    _exit(1);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGINT);
}

TEST_CASE("a study that is refused while it is prepared writes nothing") {
  const ScratchDirectory scratch;
  const Configuration study = load_configuration(scratch.write("s.toml", "study = \"vibration\""));
  const Prepare refuse = [](const Configuration&) -> Job { throw InputError("s.toml:1", "no"); };
  RunOptions options;
  options.out = scratch.path() / "run";
  options.out_given = true;
  CHECK_THROWS_AS(run_configuration(study, {&study.schema(), refuse, nullptr, nullptr}, options),
                  InputError);
  CHECK_FALSE(fs::exists(scratch.path() / "run"));
}

TEST_CASE("progress in lines comes every tenth and every ten seconds") {
  std::ostringstream stream;
  double now = 0;
  Progress progress(Progress::Mode::lines, stream, [&] { return now; });
  progress.start("water", 100);
  for (int i = 1; i <= 100; ++i) {
    now += 0.05;
    progress.update(i, i * 1e6, "3 failed");
  }
  progress.finish();
  const std::string text = stream.str();
  CHECK(std::count(text.begin(), text.end(), '\n') == 10);
  CHECK_THAT(
      text, Contains("water [##..................]  10 %  4 s left  20 M point-steps/s  3 failed"));
  CHECK_THAT(text, Contains("100 %  took 5 s"));
  stream.str("");
  progress.start("slow", 1);
  now += 11;
  progress.update(0.001);
  now += 5;
  progress.update(0.002);
  CHECK_THAT(stream.str(), Contains("slow [....................]   0 %  3:03 h left"));
  CHECK_THAT(stream.str(), !Contains("0.002"));
}

TEST_CASE("parts that run side by side are one line") {
  std::ostringstream stream;
  double now = 0;
  Progress progress(Progress::Mode::lines, stream, [&] { return now; });
  progress.start("mercury, water", 10, 2);
  now = 12;
  progress.update(4, 3e6, "1 failed", 1);
  progress.update(2, 1e6, "none failed", 0);
  now = 24;
  progress.update(5, 5e6, "2 failed", 1);
  CHECK_THAT(stream.str(), Contains("mercury, water [####................]  20 %  48 s left"));
  CHECK_THAT(stream.str(),
             Contains("35 %  45 s left  0.25 M point-steps/s  none failed; 2 failed"));
}

TEST_CASE("work before a resume counts as progress, but not for the speed") {
  std::ostringstream stream;
  double now = 0;
  Progress progress(Progress::Mode::lines, stream, [&] { return now; });
  progress.start("piercing", 10);
  progress.begin_at(5, 50e6);
  now = 20;
  progress.update(6, 60e6);
  CHECK_THAT(stream.str(), Contains("60 %  80 s left  0.5 M point-steps/s"));
}

TEST_CASE("of two that hold signals the second loses none and the first restores them") {
  struct sigaction before, after;
  sigaction(SIGINT, nullptr, &before);
  {
    const Interrupt outer;
    raise(SIGINT);
    {
      const Interrupt inner;
      CHECK(Interrupt::requested());
    }
    CHECK(Interrupt::requested());
  }
  sigaction(SIGINT, nullptr, &after);
  CHECK(after.sa_handler == before.sa_handler);
  const Interrupt next;
  CHECK_FALSE(Interrupt::requested());
}

TEST_CASE("progress is published every two seconds, also when it is quiet") {
  std::ostringstream stream;
  double now = 0;
  std::vector<std::string> published;
  std::vector<double> fractions;
  Progress progress(Progress::Mode::quiet, stream, [&] { return now; });
  progress.publish_to([&](const std::string& line) { published.push_back(line); });
  progress.publish_fraction_to([&](double fraction) { fractions.push_back(fraction); });
  progress.start("water", 10);
  for (int i = 1; i <= 10; ++i) {
    now += 0.5;
    progress.update(i);
  }
  REQUIRE(published.size() == 2);
  CHECK_THAT(published[1], Contains("water") && Contains("80 %  1 s left"));
  CHECK(fractions == std::vector<double>{0.4, 0.8});
}

TEST_CASE("progress is quiet or stays on one line") {
  std::ostringstream stream;
  double now = 0;
  {
    Progress quiet(Progress::Mode::quiet, stream, [&] { return now; });
    quiet.start("a", 1);
    quiet.update(0.5);
    quiet.finish();
    CHECK(stream.str().empty());
  }
  {
    Progress live(Progress::Mode::live, stream, [&] { return now; });
    live.start("a", 1);
    now += 1;
    live.update(0.5);
    CHECK(stream.str().front() == '\r');
    CHECK_THAT(stream.str(), !Contains("\n"));
  }
  CHECK(stream.str().back() == '\n');
  CHECK(duration_text(12.4) == "12 s");
  CHECK(duration_text(185) == "3:05 min");
  CHECK(duration_text(8100) == "2:15 h");
}
