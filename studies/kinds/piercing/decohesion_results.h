#pragma once

#include <nlohmann/json.hpp>

#include "mpm/membranes/membrane.h"

namespace zona::studies {

/// What a membrane's decohesion came to: how many points flowed and opened, and what the failed
/// ones dissipated per area, next to what their surfaces would have if their opening were resolved
/// (means; null where nothing failed) [J/m^2].
nlohmann::json decohesion_results(const mpm::MembraneState<mpm::VonMises>& state);

}  // namespace zona::studies
