#include "studies/verification/evaluation/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/references/profile_errors.h"

namespace zona::studies::verification {

namespace {

std::string shown(double value) {
  return fmt::format("{:.4g}", value);
}

std::string percent(double fraction) {
  return fmt::format("{:.2g} %", 100 * fraction);
}

/// A comparison with a NaN is false: such a check fails.
Verdict pass_if(bool condition) {
  return condition ? Verdict::passed : Verdict::failed;
}

}  // namespace

Check near(const std::string& quantity, double value, double reference, double tolerance,
           const std::string& origin) {
  const double error = value / reference - 1;
  const Verdict verdict = pass_if(std::abs(error) <= tolerance);
  return {quantity,           shown(value), shown(reference), percent(error),
          percent(tolerance), origin,       verdict};
}

Check within(const std::string& quantity, double value, double reference, double tolerance,
             const std::string& origin) {
  const double error = value - reference;
  const Verdict verdict = pass_if(std::abs(error) <= tolerance);
  return {quantity,         shown(value), shown(reference), shown(error),
          shown(tolerance), origin,       verdict};
}

Check at_most(const std::string& quantity, double value, double limit, const std::string& origin) {
  return {quantity, shown(value), "", "", "<= " + shown(limit), origin, pass_if(value <= limit)};
}

Check at_least(const std::string& quantity, double value, double limit, const std::string& origin) {
  return {quantity, shown(value), "", "", ">= " + shown(limit), origin, pass_if(value >= limit)};
}

Check converges(const std::string& quantity, const std::vector<double>& sizes,
                const std::vector<double>& errors, double order, const std::string& origin) {
  const double observed = references::observed_order(sizes, errors);
  std::string series;
  for (const double error : errors) series += (series.empty() ? "" : ", ") + shown(error);
  const Verdict verdict = pass_if(observed >= order);
  return {"order of " + quantity,
          fmt::format("{:.2f}", observed),
          "",
          series,
          fmt::format(">= {:.2f}", order),
          origin,
          verdict};
}

Check reported(const std::string& quantity, double value, const std::string& reference,
               const std::string& meaning) {
  return {quantity, shown(value), reference, "", "", meaning, Verdict::reported};
}

Verdict verdict_of(const std::vector<Check>& checks) {
  const bool failed = std::any_of(checks.begin(), checks.end(), [](const Check& check) {
    return check.verdict == Verdict::failed;
  });
  return failed ? Verdict::failed : Verdict::passed;
}

std::string word(Verdict verdict) {
  constexpr const char* words[] = {"pass", "FAIL", "reported"};
  return words[static_cast<int>(verdict)];
}

}  // namespace zona::studies::verification
