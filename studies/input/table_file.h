#pragma once

#include <string>
#include <vector>

namespace zona::studies {

/// A column that a table must have: its heading is "name [unit]", in any unit of this dimension.
struct TableColumn {
  std::string name;
  std::string si_unit;
};

/// Reads a CSV file whose first row has headings such as `distance [mm], outer [um]`; empty lines
/// and those that begin with # are skipped. The columns may stand in any order; those not asked for
/// are refused. Returns one vector of values in SI per column asked for, all of one length of at
/// least one. Throws std::runtime_error that begins "file:line: ".
std::vector<std::vector<double>> read_table(const std::string& path,
                                            const std::vector<TableColumn>& columns);

/// The same from a text in memory; `name` stands for the file's name in errors.
std::vector<std::vector<double>> parse_table(const std::string& text, const std::string& name,
                                             const std::vector<TableColumn>& columns);

}  // namespace zona::studies
