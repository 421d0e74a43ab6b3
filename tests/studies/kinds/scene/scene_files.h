#pragma once

#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "mpm/files/csv_table.h"
#include "studies/kinds/scene/case.h"
#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

namespace zona::studies::testing {

/// Columns of a CSV file by their names without units; words become NaN.
inline std::map<std::string, std::vector<double>> read_columns(const std::filesystem::path& file) {
  const auto table = mpm::CsvTable::read(file.string());
  std::map<std::string, std::vector<double>> columns;
  for (const std::string& name : table.names()) columns[name] = table[name];
  return columns;
}

/// A scene that was run, with what it wrote.
class Run {
 public:
  explicit Run(const std::string& text, const std::string& arguments = "") {
    const auto file = scratch_.write("s.toml", "study = \"scene\"\n" + text);
    answer = call("run " + file.string() + " --quiet --threads 2 --out " + out().string() + " " +
                  arguments);
    INFO(answer.text);
    if (arguments.empty()) REQUIRE(answer.code == 0);
    if (std::filesystem::exists(out() / "history.csv"))
      history = read_columns(out() / "history.csv");
    if (std::filesystem::exists(out() / "profiles.csv"))
      profiles = read_columns(out() / "profiles.csv");
    results = nlohmann::json::parse(read_text(out() / "summary.json"))["results"];
  }

  std::filesystem::path out() const { return scratch_.path() / "out"; }

  Answer answer;
  std::map<std::string, std::vector<double>> history, profiles;
  nlohmann::json results;

 private:
  ScratchDirectory scratch_;
};

/// 3 x 3 x 4 cells of water with a pressure and a velocity that are linear in the place, in a grid
/// of 4 x 3 x 8 cells of 0.1 m x 0.2 m x 0.05 m.
inline const std::string stretched_water = R"toml(
[grid]
low = ["1 m", "2 m", "3 m"]
high = ["1.4 m", "2.6 m", "3.4 m"]
cell = ["0.1 m", "0.2 m", "0.05 m"]
[time]
end = "0.1 ms"
[[body]]
name = "water"
shape = "box"
low = ["1 m", "2 m", "3 m"]
high = ["1.3 m", "2.6 m", "3.2 m"]
material = "liquid"
density = "1000 kg/m^3"
pressure = "1e5*(1 + x + 2*y)"
velocity = ["0.1*x", "y", "-z"]
p_infinity = "1 MPa"
grueneisen = 4
)toml";

/// 10 x 6 x 6 cells of 0.1 m with a cube of 8 kg in the middle.
inline std::string cube_scene(const std::string& rest) {
  return R"toml([grid]
high = ["1 m", "0.6 m", "0.6 m"]
cell = "0.1 m"
[time]
end = "20 ms"
step = "0.5 ms"
[output]
fields = false
history_interval = "1 ms"
[[body]]
name = "cube"
low = ["0.2 m", "0.2 m", "0.2 m"]
high = ["0.4 m", "0.4 m", "0.4 m"]
density = "1000 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
)toml" + rest;
}

/// A tube of 40 cells along x, 1 m long, closed on all sides.
inline std::string tube_scene(const std::string& rest) {
  return R"toml([grid]
high = ["1 m", "25 mm", "25 mm"]
cell = "25 mm"
[boundary]
x_low = "roller"
x_high = "roller"
y_low = "roller"
y_high = "roller"
z_low = "roller"
z_high = "roller"
[output]
fields = false
)toml" + rest;
}

inline SceneCase scene_case(const std::string& text) {
  const ScratchDirectory scratch;
  return make_scene_case(load_configuration(scratch.write("s.toml", "study = \"scene\"\n" + text)));
}

}  // namespace zona::studies::testing
