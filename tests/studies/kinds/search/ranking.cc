#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "studies/kinds/search/pareto.h"
#include "studies/kinds/search/ranking.h"
#include "tests/studies/kinds/search/search_files.h"

using namespace zona::studies;
using namespace zona::studies::search;
using namespace zona::studies::testing;

namespace {

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

TEST_CASE("a verdict counts samples") {
  const SearchFiles files(search_study +
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
