#include <catch2/catch.hpp>

#include "studies/kinds/piercing/motion_table.h"
#include "studies/kinds/piercing/scheme_tables.h"
#include "studies/kinds/piercing/tip_table.h"
#include "studies/kinds/piercing/zona_table.h"
#include "studies/program/bundled_studies.h"
#include "tests/studies/study_files.h"

using namespace zona::studies;

namespace {

Configuration bundled(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return load_configuration(std::string(ZONA_SOURCE_DIR "/studies/") + name, overrides);
}

}  // namespace

TEST_CASE("the bundled study files are valid") {
  CHECK(bundled("vibration.toml").quantities("pulse.durations").size() == 10);
  CHECK(bundled("piercing_lateral.toml").choice("motion.kind") == "sine");
  CHECK(bundled("piercing_axial.toml").choice("motion.axis") == "axial");
  CHECK(bundled("piercing_beam.toml").quantity("pulse.peak") == 17.9e-6);
  const Configuration comparison = bundled("mercury_vs_water.toml");
  CHECK(comparison.texts("fill.fluids") ==
        std::vector<std::string>{"mercury", "water", "fluorinert", "none"});
  CHECK(comparison.quantities("fill.fluids") == std::vector<double>{13600, 1000, 1780, 0});
}

TEST_CASE("every bundled study file is valid and states its purpose") {
  for (const auto& study : bundled_studies()) {
    INFO(study.file.string());
    CHECK_NOTHROW(load_configuration(study.file));
    CHECK_FALSE(study.description.empty());
  }
  CHECK(bundled_studies().size() >= 26);
}

TEST_CASE("a vibration resolves to SI") {
  const Configuration study = bundled("vibration.toml");
  CHECK(study.kind() == "vibration");
  CHECK(study.quantity("pipette.length") == 0.01);
  CHECK(study.integer("pipette.elements") == 20);
  CHECK(study.quantities("fill.fluids") == std::vector<double>{0, 1000, 1780, 13600, 2500});
  CHECK(study.texts("fill.fluids").back() == "2500 kg/m^3");
  CHECK(study.quantities("pulse.durations").back() == 600e-6);
  CHECK(study.is_default("pipette.rayleigh_alpha"));
  CHECK_FALSE(study.is_default("pipette.length"));
  CHECK(study.line_of("pipette.length") == 5);
  CHECK_THROWS_AS(study.quantity("pipette.elements"), std::logic_error);
  CHECK_THROWS_AS(study.quantity("grid.cell"), std::logic_error);
}

TEST_CASE("a piercing's automatic values are the source's") {
  const Configuration lateral = bundled("piercing_lateral.toml");
  CHECK(simulation_end(lateral) == 100e-6);
  CHECK(lateral.read<Motion>().peak() == 13.5e-6);
  CHECK(lateral.read<Zona>().edge_length() == Approx(0.865e-6).epsilon(1e-3));
  // Glass 2300 and the bore full of mercury, 64/36 of the glass; the source states 26441.
  CHECK(lateral.read<Tip>().density_with(13600, lateral.read<GlassTube>()) ==
        Approx(26477.8).epsilon(1e-5));
  CHECK(lateral.read<Tip>().density_with(13600, lateral.read<GlassTube>()) ==
        Approx(26441).epsilon(2e-3));
  const Configuration axial = bundled("piercing_axial.toml", {"motion.duration = \"30 us\""});
  CHECK(simulation_end(axial) == 30e-6);
  const Configuration beam = bundled("piercing_beam.toml", {"time.end = \"10 us\""});
  CHECK(simulation_end(beam) == 10e-6);
}
