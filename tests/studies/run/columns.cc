#include "studies/run/columns.h"

#include <catch2/catch.hpp>

using namespace zona::studies;

TEST_CASE("columns keep their headings and values in one order") {
  const std::vector<ValueColumn<double>> columns{{"half", "m", [](double x) { return x / 2; }},
                                                 {"square", "m^2", [](double x) { return x * x; }}};
  const std::vector<Column> heads = headings(columns, {{"name", ""}});
  REQUIRE(heads.size() == 3);
  CHECK(heads[0].name == "name");
  CHECK(heads[2].name == "square");
  CHECK(heads[2].unit == "m^2");
  CHECK(row_of(columns, 3.) == std::vector<double>{1.5, 9});
}

TEST_CASE("the columns of a vector are its components at the time of the row") {
  Eigen::Vector3d force(1, 2, 3);
  std::vector<ValueColumn<>> columns;
  add_vector(columns, "force_", "N", [&] { return force; });
  REQUIRE(columns.size() == 3);
  CHECK(columns[1].name == "force_y");
  force = {4, 5, 6};
  CHECK(row_of(columns) == std::vector<double>{4, 5, 6});
}
