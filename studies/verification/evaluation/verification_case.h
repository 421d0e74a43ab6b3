#pragma once

#include <fmt/format.h>

#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "studies/verification/evaluation/check.h"
#include "studies/verification/evaluation/figure.h"
#include "studies/verification/evaluation/run_results.h"

namespace zona::studies::verification {

/// Extent of a case: the runs that fit into minutes, or all.
enum class Extent { quick, full };

/// The values of a quick verification, followed by those that a full one adds.
template <class T>
std::vector<T> of_extent(Extent extent, std::initializer_list<T> quick,
                         std::initializer_list<T> added) {
  std::vector<T> values(quick);
  if (extent == Extent::full) values.insert(values.end(), added);
  return values;
}

template <class Number>
std::string cell_override(Number millimetres) {
  return fmt::format("grid.cell=\"{} mm\"", millimetres);
}

/// A run of a study file that a case needs.
struct Run {
  std::string label;                   ///< unique in its case; names its folder, e.g. "cell-5mm"
  std::string file;                    ///< bundled study file, e.g. "verification/impact.toml"
  std::vector<std::string> overrides;  ///< key=TOML-value
};

/// Result of a case.
struct Evaluation {
  std::vector<Check> checks;
  std::vector<Figure> figures;
  std::vector<std::string> remarks;  ///< what differs from the dissertation, by how much, and why

  void add(Check check) { checks.push_back(std::move(check)); }
  void add(const std::vector<Check>& more) {
    checks.insert(checks.end(), more.begin(), more.end());
  }
  void draw(Figure figure) { figures.push_back(std::move(figure)); }
  void draw(const std::string& name, const std::string& caption, std::vector<Panel> panels) {
    figures.push_back({name, caption, std::move(panels)});
  }
};

/// An example of the dissertation, or a basic problem that it lacks, with its reference solution.
/// Study files say what is computed; a case only compares.
struct Case {
  std::string name;       ///< "shock_tube"; what the command line calls it
  std::string title;      ///< "Shock tube"
  std::string source;     ///< section, table and figure numbers; empty: not in the dissertation
  std::string reference;  ///< what the results are held against
  std::function<std::vector<Run>(Extent)> runs;
  std::function<Evaluation(const CaseResults&, Extent)> evaluate;
};

/// All cases, in the order of the dissertation.
const std::vector<Case>& cases();

}  // namespace zona::studies::verification
