#pragma once

#include <optional>
#include <string>

#include "beam/tip_history.h"
#include "coupling/tip_motion.h"
#include "studies/configuration.h"
#include "studies/piercing_model.h"

namespace zona::studies {

/// One piercing, ready to run: everything that can be wrong with the input has been found.
struct PiercingCase {
  std::string fluid;         ///< name or density as the user wrote it
  double fluid_density = 0;  ///< [kg/m^3]
  PiercingSetup setup;
  double critical_step = 0;  ///< [s]
  double step = 0;           ///< [s]
  double end = 0;            ///< [s]
  /// The tip's history that drives the pipette, of a beam or a trace, and where its window starts
  /// [s]. After an oblique pulse it is that across the pipette, with another one along it.
  std::optional<beam::TipHistory> tip_history;
  std::optional<beam::TipHistory> axial_tip_history{};
  double window_start = 0;
  double support_peak = 0;                   ///< of the pulse that drove the beam [m]
  std::vector<std::string> bath_warnings{};  ///< where the beam's fluids are taken too far
};

/// The case that a piercing or comparison study describes for one fill. Integrates the beam or
/// reads the trace where the motion asks for it. Throws InputError, naming file and line.
PiercingCase make_piercing_case(const Configuration& study, const std::string& fluid,
                                double fluid_density);

/// The part of a tip's history that [motion] lets drive the pipette, across it after a pulse at a
/// right angle. Throws InputError for a window outside the history, or a pulse at another angle.
coupling::TipMotion tip_motion(const Configuration& study, const beam::TipHistory& history);

/// The pipette of a study's [beam] table with its bore full of a fluid [kg/m^3], driven across
/// itself by its [pulse].
beam::TipHistory beam_tip_history(const Configuration& study, double fluid_density);

}  // namespace zona::studies
