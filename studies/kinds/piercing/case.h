#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beam/motion/tip_history.h"
#include "beam/pipette/fluid.h"
#include "coupling/tip_motion.h"
#include "studies/input/configuration.h"
#include "studies/kinds/piercing/model.h"

namespace zona::studies {

/// One piercing, ready to run; all its input is checked.
struct PiercingCase {
  beam::Fluid fluid;  ///< its name, or its density, as the user wrote it
  PiercingSetup setup;
  double critical_step = 0;   ///< [s]
  std::string step_bound_by;  ///< what decides the step, for a message
  double step = 0;            ///< [s]
  double end = 0;             ///< [s]
  /// The tip's history that drives the pipette, of a beam or a trace, and where its window starts
  /// [s]. After an oblique pulse it is that across the pipette, with another one along it.
  std::optional<beam::TipHistory> tip_history;
  std::optional<beam::TipHistory> axial_tip_history{};
  double window_start = 0;
  double support_peak = 0;                   ///< of the pulse that drove the beam [m]
  std::vector<std::string> bath_warnings{};  ///< where the loads of the beam's fluids are not valid
};

/// The case that a piercing or comparison study describes for one of its `fills_of`. Integrates the
/// beam or reads the trace where the motion asks for it. Throws InputError, naming file and line.
PiercingCase make_piercing_case(const Configuration& study, const beam::Fluid& fluid);

/// Motion of a beam's tip across and along its pipette, from rest. Present where the support moves
/// in that direction.
struct TipHistories {
  std::optional<beam::TipHistory> lateral{};
  std::optional<beam::TipHistory> axial{};
};

/// The part of a beam's motion that [motion] lets drive the pipette. Throws InputError for a window
/// outside the histories.
coupling::TipMotion tip_motion(const Configuration& study, const TipHistories& tip);

/// The pipette of a study's [beam] table with this fluid in its bore, after the parts of [pulse]
/// across and along it.
TipHistories beam_tip_histories(const Configuration& study, const beam::Fluid& fluid);

}  // namespace zona::studies
