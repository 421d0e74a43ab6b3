#pragma once

#include "studies/input/configuration.h"
#include "studies/input/schema.h"

namespace zona::studies {

/// The parts of a piercing that its study kinds share; each declares one or more tables.
void declare_grid(Schema& schema);
void declare_zona(Schema& schema);
void declare_fluids(Schema& schema);
/// `point_density` is the default of the key of that name.
void declare_pipette_tip(Schema& schema, const std::string& point_density);
void declare_holding_plate(Schema& schema);
void declare_window(Schema& schema);
void declare_beam_drive(Schema& schema);
/// Table [numerics].
void declare_piercing_numerics(Schema& schema);
void declare_piercing_run(Schema& schema);

/// Cross-checks of the geometry, common to all piercings.
void check_piercing_geometry(Schema& schema);

}  // namespace zona::studies
