#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "beam/motion/support_motion.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

enum class PulseShape { triangular, trapezoid, half_sine, trace, sine };

/// Parts of the support's motion across the pipette and along it: sine and cosine of the pulse's
/// angle, 1 and 0, exactly, at a right angle.
struct PulseDirection {
  double across = 1;  ///< sine
  double along = 0;   ///< cosine
};

/// The motion of the beam's support, without its duration.
struct Pulse {
  PulseShape shape;
  std::optional<double> peak;   ///< displacement [m]; empty: voltage times gain
  double angle;                 ///< to the pipette's axis [rad]
  double voltage;               ///< [V]
  double gain;                  ///< [m/V]
  double gain_uncertainty;      ///< relative [-]
  double rise_fraction;         ///< of a trapezoid's duration [-]
  int count;                    ///< of a train
  double repetition_rate;       ///< of a train [Hz]
  std::filesystem::path trace;  ///< of PulseShape::trace

  double support_peak() const { return peak ? *peak : voltage * gain; }  ///< [m]
  PulseDirection direction() const;
  /// The support's displacement by voltage, with its uncertainty, in a line; empty for a given
  /// peak.
  std::string calibration_text() const;
};

/// Duration of the pulse, in studies with one.
struct PulseDuration {
  double duration;  ///< [s]
};

/// Keys of [pulse], which must be open; a sine only where `with_sine`. Complains of a trace that is
/// missing and of trains of sines.
void declare_pulse(Schema& schema, bool with_sine);
void declare_pulse_duration(Schema& schema);

/// The motion of the support that [pulse] describes, with this duration [s] of each pulse. Throws
/// InputError for a trace that cannot be read or a train that overlaps itself.
beam::SupportMotion support_motion(const Configuration& study, double duration);
/// With the duration of PulseDuration.
beam::SupportMotion support_motion(const Configuration& study);

}  // namespace zona::studies
