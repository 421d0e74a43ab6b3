#pragma once

#include <nlohmann/json.hpp>

#include "mpm/membranes/membrane.h"

namespace zona::studies {

/// Results of a membrane's decohesion: numbers of plastic and of opening points, and two means over
/// the failed points [J/m^2]: energy dissipated per area, and the energy that their surfaces would
/// dissipate if the opening were resolved. The means are null where nothing failed.
nlohmann::json decohesion_results(const mpm::MembraneState<mpm::VonMises>& state);

}  // namespace zona::studies
