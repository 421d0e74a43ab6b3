#pragma once

#include <string>
#include <vector>

#include "beam/motion/support_motion.h"
#include "beam/motion/tip_history.h"
#include "beam/pipette/fluid.h"
#include "beam/pipette/pipette.h"
#include "beam/time/integrate.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// The fluids of fill.fluid or fill.fluids, with the names that the study gives them, a density for
/// one. The viscosity of each is fill.viscosity, for "auto" its own or, of one given by density,
/// that of water.
std::vector<beam::Fluid> fills_of(const Configuration& study);

/// The pipette of a study, filled with this fluid where [fill] says: its bore and glass density
/// stand in section [pipette], the rest in `section`, [[column]] and [bath]. Throws InputError for
/// a pipette that is no beam, or a profile that cannot be read.
beam::Pipette pipette_from(const Configuration& study, const std::string& section,
                           const beam::Fluid& fill);

/// Peak displacement of the support [m]: pulse.peak, or for "auto" voltage times gain.
double support_peak(const Configuration& study);

/// What the controller's voltage comes to, with its uncertainty, in a line; empty unless pulse.peak
/// is "auto".
std::string calibration_text(const Configuration& study);

/// Where the bath's load, that of a long cylinder that moves little, far from walls, is taken too
/// far by this motion of the tip; with numbers. `section` holds the free length. Empty without a
/// bath.
std::vector<std::string> bath_warnings(const Configuration& study, const std::string& section,
                                       const beam::TipHistory& history);

/// The motion of the support that [pulse] describes, with this duration [s] of each pulse. Throws
/// InputError for a trace that cannot be read or a train that overlaps itself.
beam::SupportMotion support_motion(const Configuration& study, double duration);

/// The samples and the integrator declared in a section by `declare_beam_integration`. With
/// stiffness-proportional damping or Maxwell elements ARKODE is implicit, because the system is
/// then stiff. Modal superposition, which cannot have a bore's fluid at every frequency, gives way
/// to the inverse transform for a filled pipette that moves along itself, but in a bath per mode.
beam::Sampling sampling_from(const Configuration& study, const std::string& section);
beam::Integrator integrator_from(const Configuration& study, const std::string& section,
                                 const beam::BeamSystem& system);

}  // namespace zona::studies
