#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "studies/kinds/search/batch_evaluator.h"
#include "studies/kinds/search/refinement.h"
#include "studies/kinds/search/tip_stage.h"
#include "studies/run/progress.h"
#include "studies/run/run_directory.h"
#include "tests/studies/kinds/search/search_files.h"

using namespace zona::studies;
using namespace zona::studies::search;
using namespace zona::studies::testing;
using Catch::Contains;

TEST_CASE("the optimiser finds the reference among pulses") {
  // The only design that moves as the reference does for long is the reference.
  std::string reference = reference_study;
  reference.replace(reference.find("1 us"), 4, "300 us");
  const SearchFiles files(R"(
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
  const SearchFiles files;
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

TEST_CASE("a batch evaluator answers its callers together and passes errors on") {
  const SearchFiles files;
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
  const SearchFiles files(R"(
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
