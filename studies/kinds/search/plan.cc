#include "studies/kinds/search/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/input/units.h"
#include "studies/kinds/piercing/schema.h"

namespace zona::studies::search {

namespace {

/// A bound of a limit in SI; nothing where none is given.
void take_bound(const Table& table, const std::string& leaf, const Measure& measure, double& bound,
                std::vector<Problem>& problems) {
  if (table.is_auto(leaf)) return;
  const TomlValue& value = table.study().setting(table.key(leaf)).written;
  const bool is_number =
      value.type == TomlValue::Type::integer || value.type == TomlValue::Type::number;
  if (measure.unit.empty() && is_number) {
    bound = value.number;
    return;
  }
  const std::string wanted =
      measure.unit.empty() ? "a number"
                           : fmt::format("a text with a unit, e.g. \"10 {}\"", measure.shown_unit);
  try {
    if (measure.unit.empty() || value.type != TomlValue::Type::text)
      throw UnitError(fmt::format("{} does not fit {}; needs {}", printable(value.written()),
                                  measure.name, wanted));
    bound = parse_quantity(value.text, measure.unit);
  } catch (const UnitError& error) {
    problems.push_back(table.problem(leaf, error.what()));
  }
}

std::vector<Limit> limits_from(const Configuration& search) {
  std::vector<Limit> limits;
  std::vector<Problem> problems;
  for (const Table& table : search.items("limit")) {
    Limit limit{&find_measure(table.choice("measure"))};
    take_bound(table, "at_least", *limit.measure, limit.least, problems);
    take_bound(table, "at_most", *limit.measure, limit.most, problems);
    if (problems.empty() && !(limit.least <= limit.most))
      problems.push_back(table.problem("at_least", "is more than at_most; nothing fits between"));
    limits.push_back(limit);
  }
  if (!problems.empty()) throw InputError(problems);
  return limits;
}

std::vector<const Measure*> measures_from(const Configuration& search, const std::string& key) {
  std::vector<const Measure*> found;
  for (const std::string& name : search.texts(key)) found.push_back(&find_measure(name));
  return found;
}

Configuration base_from(const Configuration& search) {
  Configuration base = load_reference(search.path("search.study"));
  const std::string& drive = base.choice("motion.kind");
  if (drive == "beam") return base;
  throw InputError(search.problem(
      "search.study",
      fmt::format("{} moves its tip by motion.kind = \"{}\"; needs a piercing study with "
                  "motion.kind = \"beam\"",
                  base.file().filename().string(), drive)));
}

void check_apart(const Configuration& search, const Plan& plan) {
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < plan.uncertain.size(); ++i)
    for (const Dimension& variable : plan.variables)
      if (variable.key == plan.uncertain[i].key)
        problems.push_back(search.items("uncertain")[i].problem(
            "key", "is a variable, too; a key is either chosen or uncertain"));
  const std::size_t count = combinations(plan.variables).size();
  if (plan.candidates < count)
    problems.push_back(search.problem(
        "search.candidates",
        fmt::format("{} are fewer than the {} combinations of listed values, of each of which at "
                    "least one goes on; needs at least {}",
                    plan.candidates, count, count)));
  if (!problems.empty()) throw InputError(problems);
}

}  // namespace

Configuration load_reference(const std::filesystem::path& file, const Overrides& overrides) {
  return load_configuration(file, overrides, {&piercing_schema()});
}

double Limit::excess(double value) const {
  const auto over = [](double distance, double bound) {
    return distance / std::max(std::abs(bound), 1e-300);
  };
  if (value < least) return over(least - value, least);
  return value > most ? over(value - most, most) : 0;
}

std::string Limit::text() const {
  std::string text = measure->title;
  if (std::isfinite(least)) text += " at least " + shown(*measure, least);
  if (std::isfinite(most))
    text += (std::isfinite(least) ? " and" : "") + (" at most " + shown(*measure, most));
  return text;
}

std::vector<Limit> Plan::limits_of(Measure::Of of) const {
  std::vector<Limit> chosen;
  std::copy_if(limits.begin(), limits.end(), std::back_inserter(chosen),
               [&](const Limit& limit) { return limit.measure->of == of; });
  return chosen;
}

Configuration Plan::study(const Overrides& overrides) const {
  return load_reference(base.file(), overrides);
}

Plan plan_from(const Configuration& search) {
  const auto count = [&](const char* key) { return static_cast<std::size_t>(search.integer(key)); };
  Plan plan{
      base_from(search),
      {},
      {},
      measures_from(search, "search.tip_objectives"),
      measures_from(search, "search.objectives"),
      limits_from(search),
      count("search.samples"),
      search.integer("search.evaluations"),
      static_cast<int>(search.integer("search.divisions")),
      count("search.candidates"),
      count("search.refinements"),
      search.is_auto("search.finalists") ? count("search.candidates") : count("search.finalists"),
      count("search.uncertainty_samples"),
      search.number("search.confidence"),
      search.boolean("search.derivatives"),
      search.texts("search.avoid"),
      static_cast<std::uint64_t>(search.integer("search.seed"))};
  plan.variables = dimensions_from(search, "variable", plan.base);
  plan.uncertain = dimensions_from(search, "uncertain", plan.base);
  check_apart(search, plan);
  return plan;
}

}  // namespace zona::studies::search
