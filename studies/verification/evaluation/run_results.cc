#include "studies/verification/evaluation/run_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "studies/input/input_error.h"

namespace zona::studies::verification {

RunResults::RunResults(const std::filesystem::path& directory) : directory_(directory) {
  std::ifstream stream(directory / "summary.json");
  summary_ = nlohmann::json::parse(stream, nullptr, false);
  if (summary_.is_discarded() || !summary_.contains("results")) {
    throw RunError((directory / "summary.json").string() + " is missing or no summary of a run");
  }
}

double RunResults::number(const std::string& name) const {
  const auto found = results().find(name);
  if (found == results().end() || !found->is_number()) {
    throw RunError(
        fmt::format("{} has no number {}", (directory_ / "summary.json").string(), name));
  }
  return found->get<double>();
}

double RunResults::wall_seconds() const {
  return summary_.at("cost").at("wall_time").get<double>();
}

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto upper = std::upper_bound(x.begin(), x.end(), at);
  if (upper == x.begin()) return y.front();
  if (upper == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(upper - x.begin());
  const double fraction = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return y[i - 1] + fraction * (y[i] - y[i - 1]);
}

}  // namespace zona::studies::verification
