#pragma once

#include <string>

#include "beam/integrate.h"
#include "beam/pipette.h"
#include "studies/configuration.h"

namespace zona::studies {

/// The pipette of a study, filled with a fluid of the given density [kg/m^3]: its bore and glass
/// density stand in section [pipette], the rest in `section`. Throws InputError for a pipette that
/// is no beam.
beam::Pipette pipette_from(const Configuration& study, const std::string& section,
                           double fill_density);

/// The samples and the integrator declared in a section by `declare_beam_integration`. With
/// stiffness-proportional damping ARKODE is implicit, because the system is then stiff.
beam::Sampling sampling_from(const Configuration& study, const std::string& section);
beam::Integrator integrator_from(const Configuration& study, const std::string& section,
                                 const beam::Pipette& pipette);

}  // namespace zona::studies
