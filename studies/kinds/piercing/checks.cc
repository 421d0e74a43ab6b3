#include <fmt/format.h>

#include <cmath>

#include "studies/kinds/piercing/parameters.h"
#include "studies/kinds/piercing/values.h"
#include "studies/parameters/material_parameters.h"
#include "studies/parameters/shared_parameters.h"

namespace zona::studies {

namespace {

double micro(double value) {
  return value * 1e6;
}

void check_zona(const Configuration& study, const Complain& complain) {
  const double diameter = study.quantity("zona.diameter");
  const double thickness = study.quantity("zona.thickness");
  if (thickness < diameter / 2) return;
  complain("zona.thickness",
           fmt::format("{:g} um is not thinner than the radius of {:g} um; reduce "
                       "it or enlarge zona.diameter",
                       micro(thickness), micro(diameter / 2)));
}

void check_domain(const Configuration& study, const Complain& complain) {
  const double domain = study.quantity("grid.domain");
  const double cell = study.quantity("grid.cell");
  const double diameter = study.quantity("zona.diameter");
  const double margin = 2 * cell;  // one cell of medium on either side
  if (diameter + margin > domain) {
    complain("grid.domain",
             fmt::format("{:g} um do not hold the zona of {:g} um with a cell of medium on either "
                         "side; needs at least {:g} um",
                         micro(domain), micro(diameter), micro(diameter + margin)));
  }
  constexpr double most_cells = 1000;
  if (domain / cell > most_cells) {
    complain("grid.cell",
             fmt::format("{:g} um cut the domain of {:g} um into {:.0f} cells along an "
                         "edge; at most 1000 are allowed, so choose at least {:g} um",
                         micro(cell), micro(domain), domain / cell, micro(domain / most_cells)));
  }
}

void check_axis_length(const Configuration& study, const Complain& complain) {
  const double cell = study.quantity("grid.cell");
  const double plate = study.boolean("plate.enabled")
                           ? cell * static_cast<double>(study.integer("plate.thickness_cells"))
                           : 0;
  const double needed =
      plate + study.quantity("zona.diameter") + study.quantity("pipette.tip_length");
  const double domain = study.quantity("grid.domain");
  if (needed <= domain) return;
  complain("grid.domain", fmt::format("{:g} um do not hold the plate, the zona and the tip of the "
                                      "pipette in a row, {:g} um; enlarge it or shorten "
                                      "pipette.tip_length",
                                      micro(domain), micro(needed)));
}

void check_plate(const Configuration& study, const Complain& complain) {
  if (!study.boolean("plate.enabled")) return;
  const double side = study.quantity("plate.side");
  const double domain = study.quantity("grid.domain");
  if (side <= domain) return;
  complain("plate.side", fmt::format("{:g} um are more than the domain of {:g} um; choose at most "
                                     "grid.domain",
                                     micro(side), micro(domain)));
}

void check_cell_against_curvature(const Configuration& study, const Complain& complain) {
  const double cell = study.quantity("grid.cell");
  const double diameter = study.quantity("zona.diameter");
  if (cell <= diameter / 8) return;
  complain("grid.cell",
           fmt::format("{:g} um are too coarse for the curvature of a zona of {:g} um; "
                       "needs at most an eighth of its diameter, {:g} um",
                       micro(cell), micro(diameter), micro(diameter / 8)));
}

/// Membrane points further apart than half a cell leave nodes without mass between them, and the
/// membrane tears for no physical reason.
void check_membrane_points(const Configuration& study, const Complain& complain) {
  const double cell = study.quantity("grid.cell");
  const double edge = zona_edge_length(study);
  if (edge <= cell / 2) return;
  const long level =
      study.integer("zona.level") + std::lround(std::ceil(std::log2(2 * edge / cell)));
  const long finest = 9;
  const std::string finer = level <= finest ? fmt::format("level {} or ", level) : "";
  complain(
      "zona.level",
      fmt::format("the membrane points stand {:.3g} um apart, more than half a cell of {:g} um, "
                  "and the membrane would tear numerically; needs {}a cell of at least {:.3g} um",
                  micro(edge), micro(cell), finer, micro(2 * edge)));
}

void check_pipette(const Configuration& study, const Complain& complain) {
  check_bore("pipette", study, complain);
  const double outer = study.quantity("pipette.outer_diameter");
  const double diameter = study.quantity("zona.diameter");
  if (outer < diameter) return;
  complain("pipette.outer_diameter", fmt::format("{:g} um are not less than the zona's {:g} um; "
                                                 "choose a thinner pipette",
                                                 micro(outer), micro(diameter)));
}

void check_zona_law(const Configuration& study, const Complain& complain) {
  check_von_mises("zona.", study, complain);
  const std::string& law = study.choice("zona.law");
  if (study.choice("zona.stress_update") == "total" || law == "elastic") return;
  complain("zona.stress_update",
           fmt::format("\"increments\" are for zona.law = \"elastic\", not for \"{}\"; needs "
                       "\"total\"",
                       law));
}

}  // namespace

void check_piercing_geometry(Schema& schema) {
  schema.check(check_zona);
  schema.check(check_zona_law);
  schema.check(check_domain);
  schema.check(check_axis_length);
  schema.check(check_plate);
  schema.check(check_cell_against_curvature);
  schema.check(check_membrane_points);
  schema.check(check_pipette);
}

}  // namespace zona::studies
