#pragma once

#include <vector>

#include "studies/input/table_keys.h"

namespace zona::studies {

enum class Supports { clamped, pinned };

/// Supports of the beam, in [pipette].
struct Support {
  Supports supports;
};

/// The pulses of a vibration study, a run each, in [pulse].
struct Pulses {
  std::vector<double> durations;            ///< [s]
  std::vector<double> angular_frequencies;  ///< of sines [rad/s]
};

/// Output of a vibration study.
struct VibrationOutput {
  bool history;
  bool sensitivities;
};

/// Keys of these structs; those of [pipette] and [pulse] in sections that are open.
void declare_supports(Schema& schema, const std::string& section);
void declare_pulses(Schema& schema);
void declare_vibration_output(Schema& schema);

}  // namespace zona::studies
