#pragma once

#include <string>

#include "beam/integrate.h"
#include "beam/pipette.h"
#include "studies/configuration.h"

namespace zona::studies {

/// The pipette declared in a section of a study (bore, glass and beam), filled with a fluid of the
/// given density [kg/m^3].
beam::Pipette pipette_from(const Configuration& study, const std::string& section,
                           double fill_density);

/// The samples and the integrator declared in a section by `declare_beam_integration`. With
/// stiffness-proportional damping ARKODE is implicit, because the system is then stiff.
beam::Sampling sampling_from(const Configuration& study, const std::string& section);
beam::Integrator integrator_from(const Configuration& study, const std::string& section,
                                 const beam::Pipette& pipette);

}  // namespace zona::studies
