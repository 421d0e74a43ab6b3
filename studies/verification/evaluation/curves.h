#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/references/profile_errors.h"
#include "studies/verification/evaluation/figure.h"
#include "studies/verification/evaluation/run_results.h"

namespace zona::studies::verification {

/// A column in another unit: every value times a factor, or over a divisor.
std::vector<double> operator*(std::vector<double> values, double factor);
std::vector<double> operator/(std::vector<double> values, double divisor);

/// An exact solution at equal intervals from 0 to `end`.
Curve exact_curve(double end, int intervals, const std::function<double(double x)>& exact);

/// One column over another, of the rows whose time differs from `time` by `tolerance` [s] at most.
Curve curve_at(const ResultTable& table, const std::string& x, const std::string& y, double time,
               double tolerance);

/// Errors of a curve against an exact solution, all points of equal weight.
references::ProfileErrors errors_of(const Curve& curve,
                                    const std::function<double(double x)>& exact);

/// Adds an amplitude ratio over the duration of a pulse [s] (Figure 5.28): a line of exact values
/// and marks of computed ones for each fluid, whose ratios are added in a row.
void add_ratio(Panel& panel, const std::string& fluid, double duration, double exact,
               double computed);

double largest(const std::vector<double>& values);
/// The last value of a column of history.csv.
double last(const RunResults& run, const std::string& column);

}  // namespace zona::studies::verification
