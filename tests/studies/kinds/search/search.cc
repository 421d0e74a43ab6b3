#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include "studies/kinds/search/batch_evaluator.h"
#include "studies/kinds/search/pareto.h"
#include "studies/kinds/search/ranking.h"
#include "studies/kinds/search/refinement.h"
#include "studies/kinds/search/tip_stage.h"
#include "studies/run/progress.h"
#include "studies/run/run_directory.h"
#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;
using namespace zona::studies::search;
using namespace zona::studies::testing;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A beam and an egg that take a second together; the weak zona fails at once.
const char* const kReference = R"(
study = "piercing"
[motion]
kind = "beam"
window_length = "1 us"
auto_fraction = 0.4
[fill]
fluid = "mercury"
[beam]
length = "1 mm"
elements = 12
end = "500 us"
integrator = "transform"
[pulse]
duration = "60 us"
peak = "10 um"
[grid]
cell = "12 um"
domain = "168 um"
[zona]
level = 4
elastic_limit = 0.002
[cytoplasm]
points_per_cell = 1
[pipette]
points = [1, 12, 4]
)";

const char* const kSearch = R"(
study = "search"
[search]
study = "reference.toml"
objectives = ["failed_area", "residual_motion"]
samples = 20
evaluations = 10
candidates = 4
refinements = 3
finalists = 2
uncertainty_samples = 2
[[variable]]
key = "fill.fluid"
values = ["water", "none"]
[[variable]]
key = "pulse.peak"
range = ["3 um", "20 um"]
[[variable]]
key = "pulse.duration"
range = ["20 us", "100 us"]
[[uncertain]]
key = "zona.youngs_modulus"
range = ["3 kPa", "23 kPa"]
source = "published values"
[[limit]]
measure = "tip_travel"
at_least = "0.25 um"
)";

/// Reference and search in a folder of their own.
class Files {
 public:
  explicit Files(const std::string& search = kSearch, const std::string& reference = kReference) {
    scratch_.write("reference.toml", reference);
    file_ = scratch_.write("search.toml", search);
  }
  std::string file() const { return file_.string(); }
  fs::path path(const std::string& name) const { return scratch_.path() / name; }

 private:
  ScratchDirectory scratch_;
  fs::path file_;
};

nlohmann::json results_in(const fs::path& directory) {
  return nlohmann::json::parse(read_text(directory / "summary.json"))["results"];
}

/// What is wrong with a search whose text is changed.
std::string trouble_of(const std::string& what, const std::string& instead) {
  std::string text = kSearch;
  const std::size_t place = text.find(what);
  REQUIRE(place != std::string::npos);
  const Files files(text.replace(place, what.size(), instead));
  const Answer answer = call("check " + files.file());
  CHECK(answer.code == 2);
  return answer.text;
}

std::vector<std::vector<double>> random_points(std::size_t count, std::size_t dimensions) {
  std::mt19937 random(7);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (auto& point : points)
    for (double& x : point) x = static_cast<double>(random() % 12);  // with ties
  return points;
}

bool dominates(const std::vector<double>& a, const std::vector<double>& b) {
  bool less = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] > b[k]) return false;
    less = less || a[k] < b[k];
  }
  return less;
}

}  // namespace

TEST_CASE("a Latin hypercube has one point in every layer of every axis") {
  const std::size_t samples = 37;
  const auto points = latin_hypercube(4, samples, 5);
  REQUIRE(points.size() == samples);
  for (std::size_t d = 0; d < 4; ++d) {
    std::set<int> layers;
    for (const auto& point : points) layers.insert(static_cast<int>(point[d] * samples));
    CHECK(layers.size() == samples);
    CHECK(*layers.rbegin() == static_cast<int>(samples) - 1);
  }
  CHECK(points == latin_hypercube(4, samples, 5));
  CHECK(points != latin_hypercube(4, samples, 6));
}

TEST_CASE("Pareto levels are those of their definition") {
  for (const std::size_t dimensions : {1u, 2u, 3u}) {
    const auto points = random_points(120, dimensions);
    const std::vector<int> levels = pareto_levels(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      // One more than the highest level that dominates it.
      int level = 0;
      for (std::size_t j = 0; j < points.size(); ++j)
        if (dominates(points[j], points[i])) level = std::max(level, levels[j] + 1);
      CHECK(levels[i] == level);
    }
    for (const std::size_t i : pareto_front(points)) CHECK(levels[i] == 0);
  }
}

TEST_CASE("spread points begin with the least and never repeat") {
  const auto points = random_points(60, 2);
  const auto chosen = spread(points, 5);
  REQUIRE(chosen.size() == 5);
  for (const auto& point : points) CHECK(points[chosen[0]] <= point);
  CHECK(std::set<std::size_t>(chosen.begin(), chosen.end()).size() == 5);
  CHECK(spread({{1., 2.}, {1., 2.}}, 5).size() == 1);
  CHECK(spread({}, 3).empty());
}

TEST_CASE("weightings fill the simplex: binomial(divisions + objectives - 1, divisions)") {
  CHECK(simplex_lattice(1, 3) == std::vector<std::vector<double>>{{1}});
  CHECK(simplex_lattice(2, 2) == std::vector<std::vector<double>>{{1, 0}, {0.5, 0.5}, {0, 1}});
  CHECK(simplex_lattice(3, 4).size() == 15);
  for (const auto& weights : simplex_lattice(3, 4))
    CHECK(weights[0] + weights[1] + weights[2] == Approx(1));
}

TEST_CASE("quantiles and rank correlations are those of the textbook") {
  CHECK(quantile({3, 1, 2}, 0.5) == 2);
  CHECK(quantile({0, 10}, 0.05) == Approx(0.5));
  CHECK(quantile({4}, 0.95) == 4);
  CHECK(rank_correlation({1, 2, 3, 4}, {1, 8, 27, 64}) == Approx(1));
  CHECK(rank_correlation({1, 2, 3, 4}, {-1, -2, -30, -31}) == Approx(-1));
  CHECK(rank_correlation({1, 2, 3}, {5, 5, 5}) == 0);
  // Kendall and Gibbons' formula 1 - 6 sum d^2 / (n^3 - n), d = (0, 1, 1, 0, 0).
  CHECK(rank_correlation({1, 2, 3, 4, 5}, {1, 3, 2, 4, 5}) == Approx(1 - 6. * 2 / 120));
}

TEST_CASE("the optimiser finds the reference among pulses") {
  // The only design that moves as the reference does for long is the reference.
  std::string reference = kReference;
  reference.replace(reference.find("1 us"), 4, "300 us");
  const Files files(R"(
study = "search"
[search]
study = "reference.toml"
tip_objectives = ["mismatch"]
samples = 30
evaluations = 200
candidates = 1
[[variable]]
key = "pulse.peak"
range = ["3 um", "30 um"]
[[variable]]
key = "pulse.duration"
range = ["20 us", "200 us"]
scale = "logarithmic"
[[variable]]
key = "fill.fluid"
values = ["mercury"]
)",
                    reference);
  const Plan plan = plan_from(load_configuration(files.file()));
  RunDirectory directory = RunDirectory::named(files.path("out"));
  std::ostringstream nowhere;
  Progress progress(Progress::Mode::quiet, nowhere);
  nlohmann::json results;
  Session session{directory, progress, results, 2};
  const TipStage stage = explore(plan, session);
  CHECK(stage.designs.size() > 60);
  const Design* best = &stage.designs.front();
  for (const Design& design : stage.designs)
    if (design.tip.at("mismatch") < best->tip.at("mismatch")) best = &design;
  // Settings have four digits, and the search ends at steps of 1e-3 of the ranges.
  CHECK(best->tip.at("mismatch") < 0.01);
  const auto value = [&](std::size_t i) { return std::stod(shown_value(best->overrides[i])); };
  CHECK(value(0) == Approx(10).epsilon(0.05));
  CHECK(value(1) == Approx(60).epsilon(0.05));
  CHECK(choose_candidates(plan, stage).size() == 1);
}

TEST_CASE("a tip's measures are proportional to the support's peak, the mismatch is not") {
  const Files files;
  const Plan plan = plan_from(load_configuration(files.file()));
  TipMeter meter(plan, {});
  const Values same = *meter.measure({});
  const Values twice = *meter.measure({"pulse.peak=\"20 um\""});
  CHECK(same.at("mismatch") == 0);
  CHECK(twice.at("mismatch") == Approx(1).epsilon(1e-9));  // twice itself is off by itself
  for (const char* name :
       {"tip_amplitude", "tip_travel", "peak_velocity", "residual_motion", "support_peak"})
    CHECK(twice.at(name) == Approx(2 * same.at(name)).epsilon(1e-9));
  CHECK(same.at("support_peak") == Approx(10e-6));
  CHECK(same.at("tip_travel") <= 2 * same.at("tip_amplitude"));
  CHECK_FALSE(meter.measure({"pipette.inner_diameter=\"12 um\""}));
}

TEST_CASE("a batch evaluator answers its callers together, whatever comes in between") {
  const Files files;
  const Configuration study = load_configuration(files.path("reference.toml"));
  const std::vector<int> wanted{3, 1, 4};
  BatchEvaluator evaluator(wanted.size());
  std::vector<int> answers(wanted.size(), 0);
  std::vector<std::thread> callers;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    callers.emplace_back([&, i] {
      for (int n = 0; n < wanted[i]; ++n) answers[i] += evaluator.evaluate(i, study).get<int>();
      evaluator.leave(i);
    });
  std::vector<std::size_t> batches;
  evaluator.serve([&](const std::vector<Configuration>& piercings) {
    batches.push_back(piercings.size());
    return std::vector<nlohmann::json>(piercings.size(), 1);
  });
  for (std::thread& caller : callers) caller.join();
  CHECK(answers == wanted);
  CHECK(batches == std::vector<std::size_t>{3, 2, 2, 1});

  // After an error all callers get null, and it is thrown when they have left.
  BatchEvaluator failing(1);
  bool is_null = false;
  std::thread caller([&] {
    is_null = failing.evaluate(0, study).is_null();
    failing.leave(0);
  });
  CHECK_THROWS_WITH(failing.serve([](const auto&) -> std::vector<nlohmann::json> {
    throw std::runtime_error("no space left");
  }),
                    Contains("no space left"));
  caller.join();
  CHECK(is_null);
}

TEST_CASE("the second optimiser finds the least pulse that keeps to a limit") {
  // The support's peak is to be small, and the tip must travel by two thirds of the reference's
  // 10 um pulse: as it is proportional, the answer is 6.67 um.
  const Files files(R"(
study = "search"
[search]
study = "reference.toml"
tip_objectives = ["mismatch"]
objectives = ["support_peak"]
samples = 1
evaluations = 0
candidates = 1
refinements = 14
[[variable]]
key = "pulse.peak"
range = ["3 um", "20 um"]
[[limit]]
measure = "tip_travel"
at_least = "1 um"
)");
  Plan plan = plan_from(load_configuration(files.file()));
  TipMeter meter(plan, {});
  plan.limits.front().least = meter.reference().at("tip_travel") * 2 / 3;
  RunDirectory directory = RunDirectory::named(files.path("out"));
  std::ostringstream nowhere;
  Progress progress(Progress::Mode::quiet, nowhere);
  nlohmann::json results;
  Session session{directory, progress, results, 2};
  const CaseStore store(files.path("cases"));
  const Overrides start{"pulse.peak=\"15.75 um\""};
  const std::vector<Evaluation> evaluations =
      refine(plan, {{0, {0.75}, start, *meter.measure(start)}}, meter.reference(), store, session);
  REQUIRE_FALSE(evaluations.empty());
  CHECK(evaluations.size() <= 14);
  CHECK(evaluations.front().design.overrides == start);
  double least = evaluations.front().values.at("support_peak");
  for (const Evaluation& evaluation : evaluations) {
    CHECK(evaluation.values.at("tip_travel") >= plan.limits.front().least);
    CHECK(evaluation.values.count("failed_area") == 1);
    least = std::min(least, evaluation.values.at("support_peak"));
  }
  // It stops at steps of a hundredth of the range, 0.17 um.
  CHECK(least == Approx(6.67e-6).margin(0.2e-6));
}

TEST_CASE("a verdict counts samples") {
  const Files files(std::string(kSearch) +
                    "[[limit]]\nmeasure = \"hole_over_pipette\"\nat_least = 1\n");
  const Plan plan = plan_from(load_configuration(files.file()));
  const auto sample = [](double area, double hole, double residual) {
    return Values{
        {"failed_area", area}, {"hole_over_pipette", hole}, {"residual_motion", residual}};
  };
  Candidate reference{"reference", {}, false, "", {}};
  reference.samples = {sample(10, 2, 1), sample(20, 2, 1), sample(30, 2, 1)};
  Candidate good{"good", {}, true, "", {}};
  good.samples = {sample(5, 1, 2), sample(6, 1.5, 2), sample(7, 2, 2)};
  Candidate weak = good;  // does not always pierce
  weak.samples[0]["hole_over_pipette"] = 0.9;
  Candidate toxic = good;
  toxic.is_free = false;
  Candidate broken = good;  // a piercing went wrong: its measures are missing
  broken.samples[2].erase("failed_area");
  broken.samples[2].erase("hole_over_pipette");
  const std::vector<Candidate> all{broken, weak, toxic, good};
  const std::vector<Verdict> verdicts = judge(plan, reference, all);
  CHECK(verdicts[3].is_answer);
  CHECK(verdicts[3].measures.at("failed_area").median == 6);
  CHECK(verdicts[3].measures.at("failed_area").better == 1);
  CHECK(verdicts[3].measures.at("residual_motion").better == 0);
  CHECK_FALSE(verdicts[2].is_answer);
  CHECK(verdicts[1].keeps_limits == Approx(2. / 3));
  CHECK_FALSE(verdicts[1].is_answer);
  CHECK(verdicts[0].measures.count("failed_area") == 0);
  CHECK_FALSE(verdicts[0].is_answer);
  CHECK(final_order(plan, verdicts) == std::vector<std::size_t>{2, 3, 1, 0});
}

TEST_CASE("a search ranks designs, and what it has computed is not computed again") {
  const Files files;
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
    "a search is computed to the same bits by one thread, by two processes at once, and "
    "after it was stopped") {
  const Files files;
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

TEST_CASE("what is wrong with a search is said at its key") {
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

TEST_CASE("a search that finds nothing within the limits of the tip says so") {
  std::string text = kSearch;
  text.replace(text.find("\"0.25 um\""), 9, "\"90 um\"");
  const Files files(text);
  const Answer answer = call("run " + files.file() + " --quiet --out " + files.path("o").string());
  CHECK(answer.code == 3);
  CHECK_THAT(answer.text, Contains("keeps to the limits of the tip"));
  CHECK(fs::exists(files.path("o") / "designs.csv"));
}
