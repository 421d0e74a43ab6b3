#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace zona::mpm {

/// A table that cannot be read or used. `what()` reads "file:line:column: problem"; line and column
/// count from 1, columns in bytes. They are 0, and omitted from the text, for problems of the whole
/// file.
class TableError : public std::runtime_error {
 public:
  /// Omits line and column from the text if the line is 0.
  TableError(const std::string& file, std::size_t line, std::size_t column,
             const std::string& problem);
  /// Line from 1; 0 for the whole file.
  std::size_t line() const { return line_; }
  /// Column from 1 [bytes]; 0 for the whole file.
  std::size_t column() const { return column_; }

 private:
  std::size_t line_;
  std::size_t column_;
};

/// `value * multiplier / divisor` converts to SI. Powers of ten that are exact in floating point
/// round only once (17.9 / 1e6, not 17.9 * 1e-6).
struct UnitScale {
  double multiplier = 1;  ///< [-]
  double divisor = 1;     ///< [-]
};

/// A column that a caller wants; its heading reads "name [unit]".
struct CsvColumn {
  std::string name;     ///< of the heading, without the unit
  std::string si_unit;  ///< of the values that are read
  /// Scale of the unit in the heading. Throws `std::runtime_error` that says why if there is none.
  std::function<UnitScale(const std::string& unit)> scale_of;
  bool is_required = true;  ///< false: the file may lack it
};

/// Named columns of numbers from a CSV file:
///
///     # comments and empty lines are skipped
///     time [us], displacement [um]
///     0, 0
///     0.6, 1.25e-3
///
/// The first row holds the headings. Blanks around cells, carriage returns and a byte order mark
/// are skipped. All rows have one length; there is at least one row of values.
class CsvTable {
 public:
  /// Reads a file. If columns are `wanted`, others are refused, and so are columns without unit and
  /// values that are not finite; values are converted to SI. If none are, all columns are read as
  /// they are, and cells that hold no number become NaN. Throws `TableError`.
  static CsvTable read(const std::string& path, const std::vector<CsvColumn>& wanted = {});
  /// Reads the same format from a text in memory; `name` replaces the file's name in errors.
  static CsvTable parse(std::string text, const std::string& name,
                        const std::vector<CsvColumn>& wanted = {});

  std::size_t rows() const { return cells_.size(); }  ///< of values
  /// Names of the columns, without units, in the order of the file.
  const std::vector<std::string>& names() const { return names_; }
  bool has(const std::string& name) const;  ///< true for a column with this name
  /// A column by its name without unit. Throws `TableError` with the names there are.
  const std::vector<double>& operator[](const std::string& name) const;
  /// The rows whose cell in a column is this text. Throws `TableError` if there are none.
  CsvTable where(const std::string& name, const std::string& text) const;
  /// An error at the place of a cell; rows of values count from 0.
  TableError error(std::size_t row, const std::string& name, const std::string& problem) const;

 private:
  /// Text between two commas, without surrounding blanks; a part of `text_`.
  using Cell = std::string_view;

  CsvTable(std::string text, const std::string& file);
  std::vector<UnitScale> read_headings(const std::vector<Cell>& headings,
                                       const std::vector<CsvColumn>& wanted);
  UnitScale scale_in(Cell heading, const std::string& name,
                     const std::vector<CsvColumn>& wanted) const;
  void add_row(std::vector<Cell> cells, const std::vector<UnitScale>& scales, bool must_be_finite);
  std::size_t index(const std::string& name) const;
  TableError error_at(Cell cell, const std::string& problem) const;

  std::string file_;
  std::shared_ptr<const std::string> text_;
  std::vector<std::string> names_;
  std::vector<std::vector<Cell>> cells_;      ///< row by row
  std::vector<std::vector<double>> columns_;  ///< in the order of `names_`
};

}  // namespace zona::mpm
