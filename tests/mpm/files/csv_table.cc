#include "mpm/files/csv_table.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "tests/scratch_directory.h"

using namespace zona::mpm;
using Catch::Contains;

namespace {

UnitScale length_scale(const std::string& unit) {
  if (unit == "m") return {};
  if (unit == "um") return {1, 1e6};
  if (unit == "Gm") return {1e9, 1};
  throw std::runtime_error("unknown unit '" + unit + "'");
}

const std::vector<CsvColumn> places{
    {"x", "m", length_scale}, {"y", "m", length_scale}, {"z", "m", length_scale, false}};

std::string error_of(const std::string& text, const std::vector<CsvColumn>& wanted) {
  try {
    CsvTable::parse(text, "t.csv", wanted);
  } catch (const TableError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("columns are read by their names, in any order, and converted to SI", "[csv]") {
  const CsvTable table = CsvTable::parse(
      "\xEF\xBB\xBF# measured on a Tuesday\r\n"
      "\r\n"
      " y [um] , x[ m ]\r\n"
      "17.9,0\r\n"
      "  # a note between\r\n"
      "  -.5\t, +2e3 ",
      "t.csv", places);
  CHECK(table.rows() == 2);
  CHECK(table.names() == std::vector<std::string>{"y", "x"});
  CHECK(table["x"] == std::vector<double>{0, 2e3});
  CHECK(table["y"] == std::vector<double>{17.9 / 1e6, -0.5 / 1e6});
  CHECK_FALSE(table.has("z"));
  CHECK_THROWS_WITH(table["z"], "t.csv: it has no column z; there are y, x");
}

TEST_CASE("a table is refused with file, line and column", "[csv]") {
  const std::string head = "x [m],y [m]\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "t.csv: the file is empty; it needs a row of headings"},
      {"\n\n# only a comment\n", "t.csv: the file is empty"},
      {head, "t.csv: no values under the headings"},
      {head + "0,1x\n", "t.csv:2:3: '1x' is not a number"},
      {head + "0,0\n  1 ,  one\n", "t.csv:3:8: 'one' is not a number"},
      {head + "0,0x10\n", "t.csv:2:3: '0x10' is not a number"},
      {head + "0,+-1\n", "t.csv:2:3: '+-1' is not a number"},
      {head + "0,1 2\n", "t.csv:2:3: '1 2' is not a number"},
      {head + "0,\r\n", "t.csv:2:3: '' is not a number"},
      {head + "0,nan\n", "t.csv:2:3: 'nan' is not finite"},
      {head + "-inf,0\n", "t.csv:2:1: '-inf' is not finite"},
      {head + "0,1e999\n", "t.csv:2:3: '1e999' is out of range"},
      {"x [Gm],y [m]\n1e305,0\n", "t.csv:2:1: '1e305' is out of range"},
      {head + "0,0\n1\n", "t.csv:3:1: 1 values under 2 headings"},
      {head + "0,0\n\n#\n1,1,1\n", "t.csv:5:5: 3 values under 2 headings"},
      {"0,0\n1,1\n", "t.csv:1:1: unknown heading '0'; known are: x, y, z"},
      {"\xEF\xBB\xBF# \n\nx [m], w [m]\n", "t.csv:3:8: unknown heading 'w'"},
      {"x,y [m]\n", "t.csv:1:1: 'x' lacks its unit; write for example 'x [m]'"},
      {"x [m,y [m]\n", "t.csv:1:1: 'x [m' lacks its unit"},
      {"x [m];y [m]\n0;0\n", "t.csv:1:3: unknown unit 'm];y [m'"},
      {"x [m],y [s]\n", "t.csv:1:9: unknown unit 's'"},
      {"x [m],z [m]\n", "t.csv:1:1: no column 'y [m]'"},
      {"x [m],x [um],y [m]\n", "t.csv:1:7: 'x' occurs twice"},
  };
  for (const auto& [text, message] : cases) {
    INFO(text);
    CHECK_THAT(error_of(text, places), Contains(message));
  }
}

TEST_CASE("without wanted columns all are read, and words are NaN", "[csv]") {
  const std::string text = "profile,x [m],y\nfine,1,inf\n# no row\ncoarse,2,nan\nfine,3,1e999\n";
  const CsvTable table = CsvTable::parse(text, "t.csv");
  CHECK(table.names() == std::vector<std::string>{"profile", "x", "y"});
  CHECK(table["x"] == std::vector<double>{1, 2, 3});
  CHECK(std::isnan(table["profile"][0]));
  CHECK(std::isinf(table["y"][0]));
  CHECK(std::isnan(table["y"][1]));
  CHECK(std::isnan(table["y"][2]));
  CHECK(error_of("a,b\n1,2\n3\n", {}) == "t.csv:3:1: 1 values under 2 headings");
  CHECK(error_of("a,b\n", {}) == "t.csv: no values under the headings");

  const CsvTable fine = table.where("profile", "fine");
  CHECK(fine["x"] == std::vector<double>{1, 3});
  CHECK_THROWS_WITH(table.where("profile", "x"), "t.csv: it has no row whose profile is x");
  const TableError error = fine.error(1, "x", "is odd");
  CHECK(error.what() == std::string("t.csv:5:6: is odd"));
  CHECK(error.line() == 5);
  CHECK(error.column() == 6);
}

TEST_CASE("a table that cannot be opened is named", "[csv]") {
  const zona::tests::ScratchDirectory scratch;
  CHECK(CsvTable::read(scratch.write("a.csv", "a\n1\n").string())["a"].size() == 1);
  CHECK_THROWS_WITH(CsvTable::read(scratch / "none.csv"),
                    Contains("none.csv: cannot open the file (No such file"));
  CHECK_THROWS_AS(CsvTable::read(scratch.path().string()), TableError);  // a folder
}
