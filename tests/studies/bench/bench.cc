#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/studies/call.h"

using namespace zona::studies::testing;
using Catch::Contains;

TEST_CASE("zona bench measures a scene with one and with all threads") {
  const Answer answer = call("bench membrane --seconds 0.1 --threads 2 --json");
  REQUIRE(answer.code == 0);
  const auto document = nlohmann::json::parse(answer.text);
  CHECK(document["stream_triad"].size() == 2);
  CHECK(document["stream_triad"][0]["bytes_per_second"] > 1e8);
  CHECK_THAT(document["instruction_set"].get<std::string>(), Contains("SSE") || Contains("AVX"));
  const auto& scene = document["scenes"][0];
  CHECK(scene["scene"] == "membrane");
  CHECK(scene["points"] == 40962);
  REQUIRE(scene["timings"].size() == 2);
  for (const auto& timing : scene["timings"]) {
    double stages = 0, bytes = 0;
    for (const auto& stage : timing["stages"]) {
      stages += stage["seconds"].get<double>();
      bytes += stage["bytes_per_point"].get<double>();
    }
    // Each stage is the least of all windows, so their sum is at most the best window.
    CHECK(stages <= timing["seconds_per_step"].get<double>() * (1 + 1e-9));
    CHECK(bytes == Approx(scene["bytes_per_point"].get<double>()));
    CHECK(timing["point_steps_per_second"] >= timing["median_point_steps_per_second"]);
  }
}

TEST_CASE("zona bench lists its scenes and reports unknown ones") {
  CHECK_THAT(call("bench --list").text, Contains("piercing_2.5um") && Contains("only by name"));
  CHECK(call("bench piercing_7um").code == 2);
  CHECK_THAT(call("bench piercing_7um").text, Contains("piercing_7um") && Contains("--list"));
  CHECK(call("bench --seconds 0").code == 2);
  CHECK(call("bench --threads 0").code == 2);
}
