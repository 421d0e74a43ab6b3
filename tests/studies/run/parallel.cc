#include "studies/run/parallel.h"

#include <omp.h>

#include <catch2/catch.hpp>
#include <sstream>
#include <stdexcept>

#include "studies/run/progress.h"

using namespace zona::studies;
using Catch::Contains;

TEST_CASE("a parallel loop visits every item once, with any number of threads") {
  for (const int threads : {0, 1, 3, 50}) {
    std::vector<int> visits(20, 0);
    parallel_for(visits.size(), {threads, 1}, [&](std::size_t i) { ++visits[i]; });
    CHECK(visits == std::vector<int>(20, 1));
  }
  parallel_for(0, {4, 1}, [](std::size_t) { FAIL("there is no item"); });
}

TEST_CASE("a parallel loop sets the OpenMP threads of its items, and of nothing else") {
  const int before = omp_get_max_threads();
  std::vector<int> threads(4, 0);
  parallel_for(threads.size(), {2, 3}, [&](std::size_t i) { threads[i] = omp_get_max_threads(); });
  CHECK(threads == std::vector<int>(4, 3));
  CHECK(omp_get_max_threads() == before);
}

TEST_CASE("a parallel loop runs all items and throws the failure of the first that failed") {
  std::vector<int> visits(10, 0);
  const auto action = [&](std::size_t i) {
    ++visits[i];
    if (i % 3 == 2) throw std::runtime_error("item " + std::to_string(i));
  };
  CHECK_THROWS_WITH(parallel_for(visits.size(), {4, 1}, action), "item 2");
  CHECK(visits == std::vector<int>(10, 1));
}

TEST_CASE("a parallel stage counts its items and ends also after a failure") {
  std::ostringstream text;
  Progress progress(Progress::Mode::lines, text);
  parallel_stage("beams", 3, 2, progress, [](std::size_t) { return std::string("mercury"); });
  CHECK_THAT(text.str(), Contains("beams") && Contains("100 %") && Contains("mercury"));
  const auto fail = [](std::size_t) -> std::string { throw std::runtime_error("no beam"); };
  CHECK_THROWS_WITH(parallel_stage("rods", 1, 1, progress, fail), "no beam");
  CHECK_THAT(text.str(), Contains("rods"));
}
