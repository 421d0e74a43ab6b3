#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "studies/input/parameter.h"

namespace zona::studies {

/// A text is not a formula, or its value is not allowed; what() says why and where.
class FormulaError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A function of place, "sin(pi*x)", or of time, written in a study file. Variables
/// and value are in SI. The grammar is muParser's (+ - * / ^, sin, exp, sqrt, ..., a < b ? c : d),
/// with pi. A quantity with its unit, "10 m/s", is a constant.
///
/// Copies share one evaluator: do not call them from several threads at a time.
class Formula {
 public:
  /// Parses one item of the value of a parameter. Throws FormulaError.
  Formula(const std::string& text, const Parameter& parameter);

  /// The value [SI] of a constant.
  std::optional<double> constant() const { return constant_; }
  /// Value [SI] at a time [s] or a place [m]. Throws FormulaError, naming the variables' values,
  /// when it is not finite or outside the range of the declaration.
  double at(double time) const { return at_variables(&time); }
  double at(const Eigen::Vector3d& place) const { return at_variables(place.data()); }
  double at(const Eigen::Vector3d& place, double time) const {
    const double values[4] = {place.x(), place.y(), place.z(), time};
    return at_variables(values);
  }

 private:
  struct Evaluator;

  void compile(const Parameter& parameter);
  double at_variables(const double* values) const;

  std::string text_;
  std::string unit_;
  Range range_;
  std::vector<std::string> variables_;
  std::optional<double> constant_;
  std::shared_ptr<Evaluator> evaluator_;
};

}  // namespace zona::studies
