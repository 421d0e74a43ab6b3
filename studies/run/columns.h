#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace zona::studies {

/// Heading of a column of a table of results; the unit is SI, empty for a pure number.
struct Column {
  std::string name;
  std::string unit;
};

/// A column together with its value in a row, which follows from a `Source`: a case, an index, or
/// nothing but what the function has captured.
template <class... Source>
struct ValueColumn {
  std::string name;
  std::string unit;
  std::function<double(const Source&...)> value;
};

/// Adds three columns, the components of a vector, named `prefix` and x, y, z.
inline void add_vector(std::vector<ValueColumn<>>& columns, const std::string& prefix,
                       const std::string& unit, const std::function<Eigen::Vector3d()>& value) {
  for (const int axis : {0, 1, 2})
    columns.push_back({prefix + "xyz"[axis], unit, [value, axis] { return value()[axis]; }});
}

/// Headings, after those of columns that are written in another way, e.g. of a word.
template <class... Source>
std::vector<Column> headings(const std::vector<ValueColumn<Source...>>& columns,
                             std::vector<Column> before = {}) {
  for (const auto& column : columns) before.push_back({column.name, column.unit});
  return before;
}

template <class... Source>
std::vector<double> row_of(const std::vector<ValueColumn<Source...>>& columns,
                           const Source&... source) {
  std::vector<double> row;
  for (const auto& column : columns) row.push_back(column.value(source...));
  return row;
}

}  // namespace zona::studies
