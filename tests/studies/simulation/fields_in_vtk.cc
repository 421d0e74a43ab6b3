#include "tests/studies/kinds/scene/scene_files.h"

using namespace zona::studies::testing;
using Catch::Contains;

namespace {

/// What VTK's two readers, those of ParaView, find in fields.xdmf of a directory; one item each.
nlohmann::json read_with_vtk(const std::filesystem::path& directory) {
  const Answer answer = run_command("pvpython --force-offscreen-rendering " ZONA_SOURCE_DIR
                                    "/tests/studies/simulation/read_with_vtk.py " +
                                    (directory / "fields.xdmf").string());
  INFO(answer.text);
  REQUIRE(answer.code == 0);
  const auto read = nlohmann::json::parse(answer.text.substr(answer.text.find("[{")));
  REQUIRE(read.size() == 2);
  return read;
}

/// Whether ParaView's Python is there to read with.
bool has_vtk() {
  const bool found = has_program("pvpython");
  if (!found) WARN("there is no pvpython to read with");
  return found;
}

void check_vector(const nlohmann::json& found, const std::vector<double>& wanted) {
  INFO(found);
  REQUIRE(found.size() == wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(found[i] == Approx(wanted[i]));
}

}  // namespace

TEST_CASE("VTK reads fluids as points and as cell averages at their places") {
  if (!has_vtk()) return;
  // At the start the mean of a linear field over a cell is its value in the middle.
  const Run run(stretched_water + R"toml([[body]]
name = "water_cells"
shape = "box"
low = ["1.2 m", "2.4 m", "3.3 m"]
high = ["1.3 m", "2.6 m", "3.4 m"]
density = "1000 kg/m^3"
youngs_modulus = "1 kPa"
poisson_ratio = 0.3
[output]
fields_interval = "0.05 ms"
)toml");
  for (const auto& read : read_with_vtk(run.out())) {
    CHECK(read["times"].front() == 0.0);
    CHECK(read["times"].back() == Approx(1e-4));
    const auto& points = read["frames"][0]["water"];
    CHECK(points["type"] == "vtkUnstructuredGrid");
    CHECK(points["points"] == 288);
    CHECK(points["cells"] == 288);  // without them ParaView draws nothing

    const auto& cells = read["frames"][0]["water_cells_"];
    CHECK(cells["type"] == "vtkRectilinearGrid");
    CHECK(cells["cells"] == 4 * 3 * 8);
    check_vector(cells["bounds"], {1, 1.4, 2, 2.6, 3, 3.4});
    const auto& arrays = cells["cell_arrays"];
    CHECK(arrays["pressure"][0][0] == Approx(1e5 * (1 + 1.05 + 2 * 2.1)));
    check_vector(arrays["velocity"][0], {0.105, 2.1, -3.025});
    CHECK(arrays["density"][0][0] == Approx(1000));
    CHECK(arrays["points"][0][0] == 8);
    CHECK(arrays["points"][1][0] == 0);
  }
}

TEST_CASE("VTK reads a piercing: the zona as triangles, physical times") {
  if (!has_vtk()) return;
  const ScratchDirectory scratch;
  const auto out = scratch.path() / "out";
  const Answer answer = call(
      "run " ZONA_SOURCE_DIR "/studies/piercing_lateral_quick.toml --quiet --out " + out.string() +
      " --set 'grid.cell=\"12 um\"' --set 'grid.domain=\"168 um\"' --set zona.level=4"
      " --set cytoplasm.points_per_cell=1 --set 'time.end=\"0.3 us\"'"
      " --set 'output.fields_interval=\"0.1 us\"'");
  INFO(answer.text);
  REQUIRE(answer.code == 0);
  for (const auto& read : read_with_vtk(out)) {
    REQUIRE(read["times"].size() == 4);
    CHECK(read["times"].back() == Approx(0.3e-6));
    const auto& frame = read["frames"].back();
    CHECK(frame["zona"]["points"] == 2562);
    CHECK(frame["zona"]["cells"] == 5120);
    for (const char* field : {"failed", "strain", "damage", "tension", "velocity"})
      CHECK(frame["zona"]["point_arrays"].contains(field));
    CHECK(frame.contains("pipette"));
    CHECK(frame["cytoplasm_cells"]["cells"] == 14 * 14 * 14);
    CHECK(frame["medium_cells"]["cell_arrays"].contains("pressure"));
  }
}
