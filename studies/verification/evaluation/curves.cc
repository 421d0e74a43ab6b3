#include "studies/verification/evaluation/curves.h"

#include <algorithm>
#include <cmath>

namespace zona::studies::verification {

std::vector<double> operator*(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

std::vector<double> operator/(std::vector<double> values, double divisor) {
  for (double& value : values) value /= divisor;
  return values;
}

Curve exact_curve(double end, int intervals, const std::function<double(double x)>& exact) {
  Curve curve{"exact", {}, {}, Style::reference};
  for (int i = 0; i <= intervals; ++i) {
    const double x = end * i / intervals;
    curve.add(x, exact(x));
  }
  return curve;
}

Curve curve_at(const ResultTable& table, const std::string& x, const std::string& y, double time,
               double tolerance) {
  Curve curve;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (std::abs(table["time"][i] - time) > tolerance) continue;
    curve.add(table[x][i], table[y][i]);
  }
  return curve;
}

references::ProfileErrors errors_of(const Curve& curve,
                                    const std::function<double(double x)>& exact) {
  std::vector<references::Sample> samples;
  for (std::size_t i = 0; i < curve.x.size(); ++i) samples.push_back({curve.x[i], curve.y[i]});
  return references::profile_errors(samples, exact);
}

void add_ratio(Panel& panel, const std::string& fluid, double duration, double exact,
               double computed) {
  auto& curves = panel.curves;
  if (curves.empty() || curves[curves.size() - 2].label != fluid) {
    curves.push_back({fluid});
    curves.push_back({"", {}, {}, Style::points});
  }
  curves[curves.size() - 2].add(duration * 1e6, exact);
  curves.back().add(duration * 1e6, computed);
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

double last(const RunResults& run, const std::string& column) {
  return run.table("history.csv")[column].back();
}

}  // namespace zona::studies::verification
