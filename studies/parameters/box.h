#pragma once

#include <string>
#include <vector>

#include "mpm/grid/background_grid.h"
#include "mpm/grid/region.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// Opposite corners `low` and `high` of a box in a table of that name, by default the whole grid.
void declare_box(Schema& schema, const std::string& section, const std::string& documentation,
                 const std::vector<Condition>& conditions = {});

/// Complains of a box whose corners are the wrong way round, or at one place unless it may be flat.
void check_box(const Table& table, const Complain& complain, bool may_be_flat);

/// The box `low` to `high` of a table, which count from `origin` [m]; corners left to the grid are
/// the grid's.
mpm::Box box_of(const Table& table, const mpm::BackgroundGrid& grid,
                const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

}  // namespace zona::studies
