#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <set>

#include "studies/program/bundled_studies.h"
#include "studies/verification/campaign.h"
#include "studies/verification/evaluation/verification_case.h"
#include "tests/scratch_directory.h"
#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::verification;
using namespace zona::studies::testing;
using Catch::Contains;
using zona::tests::ScratchDirectory;
namespace fs = std::filesystem;

TEST_CASE("checks pass and fail at their limits") {
  CHECK(near("a", 1.009, 1, 0.01, "").verdict == Verdict::passed);
  CHECK(near("a", -1.02, -1, 0.01, "").verdict == Verdict::failed);
  CHECK(near("a", NAN, 1, 0.01, "").verdict == Verdict::failed);
  CHECK(within("a", 0.5, 0, 0.5, "").verdict == Verdict::passed);
  CHECK(within("a", -0.6, 0, 0.5, "").verdict == Verdict::failed);
  CHECK(at_most("a", NAN, 1, "").verdict == Verdict::failed);
  CHECK(at_least("a", 1, 1, "").verdict == Verdict::passed);
  CHECK(verdict_of({reported("a", 1, "none", "")}) == Verdict::passed);
  CHECK(verdict_of({reported("a", 1, "none", ""), at_most("a", 2, 1, "")}) == Verdict::failed);
}

TEST_CASE("a check of convergence holds the slope of the errors against a limit") {
  CHECK(converges("a", {0.1, 0.2}, {1, 2}, 0.99, "").verdict == Verdict::passed);
  CHECK(converges("a", {0.1, 0.2}, {1, 2}, 1.1, "").verdict == Verdict::failed);
}

TEST_CASE("tables of a run are read by the names of their columns") {
  const ScratchDirectory scratch;
  CHECK_THROWS_WITH(RunResults(scratch.path()), Contains("summary.json"));
  scratch.write("summary.json", "{\"results\": {}}");
  scratch.write("table.csv", "time [s],failed_points\n0,1\n0.5,inf\n1,3\n");
  const ResultTable table = RunResults(scratch.path()).table("table.csv");
  CHECK(interpolate(table["time"], {1, 2, 3}, 0.75) == Approx(2.5));
  CHECK(interpolate(table["time"], {1, 2, 3}, 9) == 3);
  CHECK(std::isinf(table["failed_points"][1]));
}

TEST_CASE("every verification case needs valid runs, each once") {
  std::vector<const Case*> all;
  std::set<std::string> names;
  for (const Case& c : cases()) {
    all.push_back(&c);
    CHECK(names.insert(c.name).second);
    for (const Extent extent : {Extent::quick, Extent::full}) {
      std::set<std::string> labels;
      for (const Run& run : c.runs(extent)) {
        INFO(c.name << ", " << run.label);
        CHECK(labels.insert(run.label).second);
        CHECK_NOTHROW(load_configuration(study_directory() / run.file, run.overrides));
      }
    }
  }
}

TEST_CASE("zona verify computes what is missing, and only that") {
  const ScratchDirectory scratch;
  const std::string command = "verify pipette_frequencies --quick --out " + scratch.path().string();
  const Answer first = call(command);
  CHECK(first.code == 0);
  CHECK_THAT(first.text, Contains("pipette_frequencies: pass") && Contains("1 of 1 cases passed"));
  CHECK_THAT(read_text(scratch / "verification.md"), Contains("| frequency 1 of Table 5.6"));

  const fs::path run = fs::path(scratch.path()) / "pipette_frequencies" / "elements-20";
  const fs::path other = run.parent_path() / "elements-10";
  const auto computed = [](const fs::path& of) { return fs::last_write_time(of / "study.toml"); };
  const auto before = computed(run), other_before = computed(other);
  CHECK_THAT(call(command).text, Contains("nothing"));
  CHECK(computed(run) == before);

  std::ofstream(run / "summary.json") << "{";
  const Answer again = call(command);
  CHECK(again.code == 0);
  CHECK(computed(run) != before);
  CHECK(computed(other) == other_before);
}

TEST_CASE("zona verify finds the same with any number of threads") {
  const ScratchDirectory scratch;
  const auto found = [&](int threads) {
    const std::string out = scratch / std::to_string(threads);
    const Answer answer = call("verify stokes free_fall drifting_bar --quick --quiet --threads " +
                               std::to_string(threads) + " --out " + out);
    CHECK(answer.code == 0);
    return answer.text.substr(0, answer.text.find("the page is")) +
           read_text(out + "/drifting_bar/quadratic-40/history.csv");
  };
  const std::string one = found(1);
  CHECK_THAT(one, Contains("stokes: pass") && Contains("free_fall: pass"));
  // In the order of the list, whatever ended first.
  CHECK(one.find("stokes: pass") < one.find("free_fall: pass"));
  CHECK(found(3) == one);
}

TEST_CASE("Ctrl-C stops zona verify, and the same command continues") {
  const ScratchDirectory scratch;
  const std::string out = scratch / "out";
  const std::string command = "verify vortex --quick --quiet --threads 2 --out " + out;
  const Answer stopped =
      run_command("(" ZONA_PROGRAM " " + command + " & p=$!; for i in $(seq 1200); do ls " + out +
                  "/vortex/*/study.toml > /dev/null 2>&1 && break; sleep 0.05; "
                  "done; kill -INT $p; wait $p)");
  CHECK(stopped.code == 130);
  CHECK_THAT(stopped.text, Contains("the same command continues from here"));
  CHECK(call(command).code == 0);
}

TEST_CASE("zona verify lists its cases and reports unknown ones") {
  CHECK(call("verify pipete_amplitude").code == 2);
  CHECK_THAT(call("verify pipete_amplitude").text, Contains("did you mean pipette_amplitude?"));
  const ScratchDirectory scratch;
  const Answer list = call("verify --list --out " + (scratch / "none"));
  CHECK(list.code == 0);
  CHECK_THAT(list.text, Contains("support_motion"));
  CHECK_FALSE(fs::exists(scratch / "none"));
}
