#pragma once

#include "beam/time/integrate.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

enum class IntegratorName { newmark, arkode, modal, transform };

/// Time integration of the beam.
struct BeamIntegration {
  double end;   ///< [s]
  double step;  ///< of the samples [s]
  IntegratorName integrator;
  double relative_tolerance;  ///< of ARKODE [-]
  double absolute_tolerance;  ///< of ARKODE [m]

  beam::Sampling sampling() const { return {end, step}; }
  /// The integrator of a system. With stiffness-proportional damping or Maxwell elements ARKODE is
  /// implicit, because the system is then stiff. Modal superposition, which cannot treat a bore's
  /// fluid at every frequency, gives way to the inverse transform for a filled pipette that moves
  /// along itself, except in a bath per mode.
  beam::Integrator integrator_of(const beam::BeamSystem& system) const;
};

/// Keys in a section that is open. Complains of too many or too few steps, and of an integrator
/// that cannot treat the bath (Bath, which must be declared).
void declare_beam_integration(Schema& schema, const std::string& section, IntegratorName preset);

}  // namespace zona::studies
