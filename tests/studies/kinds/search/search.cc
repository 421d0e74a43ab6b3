#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/studies/kinds/search/search_files.h"

using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

nlohmann::json results_in(const fs::path& directory) {
  return nlohmann::json::parse(read_text(directory / "summary.json"))["results"];
}

/// What is wrong with a search whose text is changed.
std::string trouble_of(const std::string& what, const std::string& instead) {
  std::string text = search_study;
  const std::size_t place = text.find(what);
  REQUIRE(place != std::string::npos);
  const SearchFiles files(text.replace(place, what.size(), instead));
  const Answer answer = call("check " + files.file());
  CHECK(answer.code == 2);
  return answer.text;
}

}  // namespace

TEST_CASE("a search ranks designs and reuses piercings from its cache") {
  const SearchFiles files;
  const std::string out = files.path("out").string();
  const std::string cache = " --set 'run.cache=\"" + files.path("cache").string() + "\"'";
  const Answer first = call("run " + files.file() + cache + " --threads 2 --quiet --out " + out);
  INFO(first.text);
  REQUIRE(first.code == 0);
  CHECK_THAT(first.text, Contains("reference") && Contains("water ") && Contains("none "));
  const auto results = results_in(out);
  CHECK(results["trials"] == 6);
  REQUIRE((results["candidates"].size() >= 4 && results["candidates"].size() <= 6));
  int ranked = 0;
  for (const auto& candidate : results["candidates"]) {
    CHECK(candidate["nominal"]["failed_area"].get<double>() >= 0);
    CHECK(candidate["nominal"]["tip_travel"].get<double>() >= 0.25e-6);
    if (candidate.contains("rank")) ++ranked;
  }
  CHECK(ranked == 2);
  CHECK(results["uncertain"][0]["samples"].size() == 2);
  CHECK(results["uncertain"][0]["ends"].size() == 4);
  CHECK(results["uncertain"][0]["ends"][0]["keeps_limits"] == true);  // none of the oocyte's

  // A candidate's file is a study that comes to what the search says.
  const auto best =
      *std::find_if(results["candidates"].begin(), results["candidates"].end(),
                    [](const auto& candidate) { return candidate.value("rank", 0) == 1; });
  const Answer again = call("run " + out +
                            "/candidates/1.toml --quiet --set output.fields=false "
                            "--out " +
                            files.path("best").string());
  REQUIRE(again.code == 0);
  CHECK(results_in(files.path("best"))["failed_area"] == best["nominal"]["failed_area"]);

  const auto newest = [&] {
    fs::file_time_type time{};
    for (const auto& entry : fs::recursive_directory_iterator(files.path("cache")))
      if (entry.path().filename() == "results.json") time = std::max(time, entry.last_write_time());
    return time;
  };
  const auto before = newest();
  const std::string second = files.path("second").string();
  REQUIRE(call("run " + files.file() + cache + " --threads 1 --quiet --out " + second).code == 0);
  CHECK(newest() == before);
  auto one = results, two = results_in(second);
  one["beams"].erase("seconds");
  two["beams"].erase("seconds");
  CHECK(one == two);
  CHECK(read_text(fs::path(out) / "designs.csv") == read_text(fs::path(second) / "designs.csv"));
}

TEST_CASE(
    "a search gives the same bits with one thread, with two processes and after an interrupt") {
  const SearchFiles files;
  const auto path = [&](const char* name) { return files.path(name).string(); };
  REQUIRE(call("run " + files.file() + " --threads 1 --quiet --out " + path("whole")).code == 0);
  // Two processes share a cache; each ends with everything.
  const std::string shared = " --set 'run.cache=\"" + path("shared") + "\"'";
  const auto process = [&](const char* name) {
    return std::string(ZONA_PROGRAM " run ") + files.file() + shared +
           " --threads 1 --quiet --out " + path(name);
  };
  const Answer both = run_command(process("a") + " & " + process("b") + "; wait");
  INFO(both.text);
  CHECK(both.code == 0);
  // Stopped while it pierces, then gone on with.
  run_command(std::string(ZONA_PROGRAM " run ") + files.file() + " --threads 1 --quiet --out " +
              path("stopped") + " & p=$!; for i in $(seq 1200); do ls " + path("stopped") +
              "/cases/*/lock > /dev/null 2>&1 && break; sleep 0.05; done; kill -INT $p; wait $p");
  const Answer resumed = call("run " + path("stopped") + " --resume --quiet");
  INFO(resumed.text);
  CHECK(resumed.code == 0);
  const auto same = [&](const char* name) {
    auto a = results_in(files.path("whole")), b = results_in(files.path(name));
    for (auto* results : {&a, &b}) {
      (*results)["beams"].erase("seconds");
      (*results)["reference"].erase("folder");
      for (auto& candidate : (*results)["candidates"]) candidate.erase("folder");
    }
    return a == b;
  };
  CHECK(same("a"));
  CHECK(same("b"));
  CHECK(same("stopped"));
}

TEST_CASE("errors of a search are reported at their key") {
  CHECK_THAT(trouble_of("key = \"pulse.peak\"", "key = \"pulse.peek\""),
             Contains("variable.1.key") && Contains("no key with one value"));
  CHECK_THAT(trouble_of("[\"3 um\", \"20 um\"]", "[\"20 um\", \"3 um\"]"),
             Contains("lowest and a greater highest"));
  CHECK_THAT(trouble_of("[\"3 um\", \"20 um\"]", "[\"3 um\", \"20 s\"]"), Contains("range"));
  CHECK_THAT(trouble_of("[\"3 um\", \"20 um\"]", "[\"3 um\"]"), Contains("two values"));
  CHECK_THAT(trouble_of("range = [\"3 um\", \"20 um\"]", ""), Contains("either values"));
  CHECK_THAT(trouble_of("[\"water\", \"none\"]", "[\"water\", \"nothing\"]"), Contains("nothing"));
  CHECK_THAT(trouble_of("key = \"pulse.peak\"\nrange = [\"3 um\", \"20 um\"]",
                        "key = \"zona.youngs_modulus\"\nrange = [\"3 kPa\", \"20 kPa\"]"),
             Contains("either chosen or uncertain"));
  CHECK_THAT(trouble_of("candidates = 4\nrefinements = 3\nfinalists = 2", "candidates = 1"),
             Contains("2 combinations"));
  CHECK_THAT(trouble_of("finalists = 2", "finalists = 5"), Contains("among the candidates"));
  CHECK_THAT(trouble_of("refinements = 3", "refinements = -1"), Contains("search.refinements"));
  CHECK_THAT(trouble_of("at_least = \"0.25 um\"", ""), Contains("at_most"));
  CHECK_THAT(trouble_of("\"0.25 um\"", "0.25"), Contains("unit"));
  CHECK_THAT(trouble_of("\"0.25 um\"", "\"0.25 kg\""), Contains("at_least"));
  CHECK_THAT(trouble_of("\"tip_travel\"", "\"tip_travels\""), Contains("tip_travel"));
  CHECK_THAT(trouble_of("reference.toml", "missing.toml"), Contains("missing.toml"));
  CHECK_THAT(
      trouble_of("\"reference.toml\"", "\"" ZONA_SOURCE_DIR "/studies/piercing_lateral.toml\""),
      Contains("motion.kind"));
  CHECK_THAT(trouble_of("\"reference.toml\"", "\"" ZONA_SOURCE_DIR "/studies/vibration.toml\""),
             Contains("needs one of piercing"));
}

TEST_CASE("a search without a design within the limits of the tip fails with the reason") {
  std::string text = search_study;
  text.replace(text.find("\"0.25 um\""), 9, "\"90 um\"");
  const SearchFiles files(text);
  const Answer answer = call("run " + files.file() + " --quiet --out " + files.path("o").string());
  CHECK(answer.code == 3);
  CHECK_THAT(answer.text, Contains("keeps to the limits of the tip"));
  CHECK(fs::exists(files.path("o") / "designs.csv"));
}
