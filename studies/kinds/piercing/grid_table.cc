#include "studies/kinds/piercing/grid_table.h"

#include <fmt/format.h>

namespace zona::studies {

namespace {

void check_count(const Configuration& study, const Complain& complain) {
  const double domain = study.value(&Grid::domain);
  const double cell = study.value(&Grid::cell);
  constexpr double most_cells = 1000;
  if (domain / cell <= most_cells) return;
  complain(study.key(&Grid::cell),
           fmt::format("{:g} um cut the domain of {:g} um into {:.0f} cells along an edge; at most "
                       "1000 are allowed, so choose at least {:g} um",
                       cell * 1e6, domain * 1e6, domain / cell, domain / most_cells * 1e6));
}

}  // namespace

void declare_grid(Schema& schema) {
  TableKeys<Grid> keys(schema, "grid", "The background grid of cubic cells.");
  keys.quantity("cell", &Grid::cell, "m", "6 um")
      .in("[1e-9, 1e-3]")
      .called("Delta x")
      .doc("Side length of a cell; the source uses 4, 5 and 6 um (Table 5.4).");
  keys.quantity("domain", &Grid::domain, "m", "150 um")
      .in("(0, 0.1]")
      .doc(
          "Side length of the cubic domain, rounded to whole cells. Not given in the source; 25 "
          "cells of 6 um reproduce Table 5.4, as do about 140 um at 5 um and 128 um at 4 um.");
  schema.check(check_count);
}

}  // namespace zona::studies
