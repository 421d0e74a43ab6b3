#include "studies/kinds/piercing/geometry_checks.h"

#include <fmt/format.h>

#include <cmath>

#include "studies/input/configuration.h"
#include "studies/kinds/piercing/grid_table.h"
#include "studies/kinds/piercing/plate_table.h"
#include "studies/kinds/piercing/tip_table.h"
#include "studies/kinds/piercing/zona_table.h"

namespace zona::studies {

namespace {

double micro(double value) {
  return value * 1e6;
}

void check_domain(const Configuration& study, const Complain& complain) {
  const double domain = study.value(&Grid::domain);
  const double diameter = study.value(&Zona::diameter);
  const double margin = 2 * study.value(&Grid::cell);  // one cell of medium on either side
  if (diameter + margin <= domain) return;
  complain(study.key(&Grid::domain),
           fmt::format("{:g} um do not hold the zona of {:g} um with a cell of medium on either "
                       "side; needs at least {:g} um",
                       micro(domain), micro(diameter), micro(diameter + margin)));
}

void check_axis_length(const Configuration& study, const Complain& complain) {
  const double cell = study.value(&Grid::cell);
  const double plate =
      study.value(&Plate::enabled) ? cell * study.value(&Plate::thickness_cells) : 0;
  const double needed = plate + study.value(&Zona::diameter) + study.value(&Tip::tip_length);
  const double domain = study.value(&Grid::domain);
  if (needed <= domain) return;
  complain(study.key(&Grid::domain),
           fmt::format("{:g} um do not hold the plate, the zona and the tip of the pipette in a "
                       "row, {:g} um; enlarge it or shorten {}",
                       micro(domain), micro(needed), study.key(&Tip::tip_length)));
}

void check_plate(const Configuration& study, const Complain& complain) {
  if (!study.value(&Plate::enabled)) return;
  const double side = study.value(&Plate::side);
  const double domain = study.value(&Grid::domain);
  if (side <= domain) return;
  complain(study.key(&Plate::side),
           fmt::format("{:g} um are more than the domain of {:g} um; choose at most {}",
                       micro(side), micro(domain), study.key(&Grid::domain)));
}

void check_cell_against_curvature(const Configuration& study, const Complain& complain) {
  const double cell = study.value(&Grid::cell);
  const double diameter = study.value(&Zona::diameter);
  if (cell <= diameter / 8) return;
  complain(
      study.key(&Grid::cell),
      fmt::format("{:g} um are too coarse for the curvature of a zona of {:g} um; needs at most "
                  "an eighth of its diameter, {:g} um",
                  micro(cell), micro(diameter), micro(diameter / 8)));
}

/// Membrane points further apart than half a cell leave nodes without mass between them, and the
/// membrane tears for no physical reason.
void check_membrane_points(const Configuration& study, const Complain& complain) {
  const double cell = study.value(&Grid::cell);
  Zona zona{};
  zona.diameter = study.value(&Zona::diameter);
  zona.level = study.value(&Zona::level);
  const double edge = zona.edge_length();
  if (edge <= cell / 2) return;
  const long level = zona.level + std::lround(std::ceil(std::log2(2 * edge / cell)));
  constexpr long finest = 9;
  const std::string finer = level <= finest ? fmt::format("level {} or ", level) : "";
  complain(
      study.key(&Zona::level),
      fmt::format("the membrane points stand {:.3g} um apart, more than half a cell of {:g} um, "
                  "and the membrane would tear numerically; needs {}a cell of at least {:.3g} um",
                  micro(edge), micro(cell), finer, micro(2 * edge)));
}

void check_pipette(const Configuration& study, const Complain& complain) {
  const double outer = study.value(&GlassTube::outer_diameter);
  const double diameter = study.value(&Zona::diameter);
  if (outer < diameter) return;
  complain(study.key(&GlassTube::outer_diameter),
           fmt::format("{:g} um are not less than the zona's {:g} um; choose a thinner pipette",
                       micro(outer), micro(diameter)));
}

}  // namespace

void check_piercing_geometry(Schema& schema) {
  schema.check(check_domain);
  schema.check(check_axis_length);
  schema.check(check_plate);
  schema.check(check_cell_against_curvature);
  schema.check(check_membrane_points);
  schema.check(check_pipette);
}

}  // namespace zona::studies
