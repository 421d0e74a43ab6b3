#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beam/integrate.h"
#include "beam/pipette.h"
#include "beam/support_motion.h"
#include "beam/tip_history.h"
#include "studies/configuration.h"

namespace zona::studies {

/// The pipette of a study, filled with a fluid of the given density [kg/m^3] where [fill] says: its
/// bore and glass density stand in section [pipette], the rest in `section`, [[column]] and [bath].
/// Throws InputError for a pipette that is no beam, or a profile that cannot be read.
beam::Pipette pipette_from(const Configuration& study, const std::string& section,
                           double fill_density);

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

/// Motion of the tip across and along its pipette, from rest, where the support moves it; one or
/// both.
struct TipHistories {
  std::optional<beam::TipHistory> lateral;
  std::optional<beam::TipHistory> axial;
};

/// The samples and the integrator declared in a section by `declare_beam_integration`. With
/// stiffness-proportional damping ARKODE is implicit, because the system is then stiff.
beam::Sampling sampling_from(const Configuration& study, const std::string& section);
beam::Integrator integrator_from(const Configuration& study, const std::string& section,
                                 const beam::Pipette& pipette);

}  // namespace zona::studies
