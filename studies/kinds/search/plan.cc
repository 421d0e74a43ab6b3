#include "studies/kinds/search/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/input/units.h"
#include "studies/kinds/piercing/motion_table.h"
#include "studies/kinds/piercing/schema.h"
#include "studies/kinds/search/limit_table.h"
#include "studies/kinds/search/variable_table.h"

namespace zona::studies::search {

namespace {

/// A bound of a limit in SI; `otherwise` where none is given. Throws UnitError.
double bound_of(const std::optional<TomlValue>& bound, const Measure& measure, double otherwise) {
  if (!bound) return otherwise;
  const bool is_number =
      bound->type == TomlValue::Type::integer || bound->type == TomlValue::Type::number;
  if (measure.unit.empty() && is_number) return bound->number;
  const std::string wanted =
      measure.unit.empty() ? "a number"
                           : fmt::format("a text with a unit, e.g. \"10 {}\"", measure.shown_unit);
  if (measure.unit.empty() || bound->type != TomlValue::Type::text)
    throw UnitError(fmt::format("{} does not fit {}; needs {}", printable(bound->written()),
                                measure.name, wanted));
  return parse_quantity(bound->text, measure.unit);
}

std::vector<Limit> limits_from(const Configuration& search) {
  std::vector<Limit> limits;
  std::vector<Problem> problems;
  for (const Table& table : search.items<LimitTable>()) {
    const auto written = table.read<LimitTable>();
    Limit limit{written.measure};
    const auto take = [&](std::optional<TomlValue> LimitTable::*member, double& bound) {
      try {
        bound = bound_of(written.*member, *limit.measure, bound);
      } catch (const UnitError& error) {
        problems.push_back(table.problem(member, error.what()));
      }
    };
    take(&LimitTable::at_least, limit.least);
    take(&LimitTable::at_most, limit.most);
    if (problems.empty() && !(limit.least <= limit.most))
      problems.push_back(
          table.problem(&LimitTable::at_least, "is more than at_most; nothing fits between"));
    limits.push_back(limit);
  }
  if (!problems.empty()) throw InputError(problems);
  return limits;
}

Configuration base_from(const Configuration& search) {
  Configuration base = load_reference(search.value(&SearchTable::study_file));
  if (base.value(&Motion::kind) == MotionKind::beam) return base;
  const std::string key = base.key(&Motion::kind);
  throw InputError(search.problem(
      &SearchTable::study_file,
      fmt::format("{0} moves its tip by {1} = \"{2}\"; needs a piercing study with {1} = \"beam\"",
                  base.file().filename().string(), key, base.text(key))));
}

void check_apart(const Configuration& search, const Plan& plan) {
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < plan.uncertain.size(); ++i)
    for (const Dimension& variable : plan.variables)
      if (variable.key == plan.uncertain[i].key)
        problems.push_back(search.items<Uncertain>()[i].problem(
            static_cast<std::string Uncertain::*>(&Varied::key),
            "is a variable, too; a key is either chosen or uncertain"));
  const std::size_t count = combinations(plan.variables).size();
  if (plan.candidates < count)
    problems.push_back(search.problem(
        &SearchTable::candidates,
        fmt::format("{} are fewer than the {} combinations of listed values, each of which needs "
                    "one; needs at least {}",
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
  Plan plan{search.read<SearchTable>(), base_from(search), {}, {}, limits_from(search)};
  plan.variables = dimensions_from<Variable>(search, plan.base);
  plan.uncertain = dimensions_from<Uncertain>(search, plan.base);
  check_apart(search, plan);
  return plan;
}

}  // namespace zona::studies::search
