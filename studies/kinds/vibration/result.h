#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beam/motion/tip_history.h"
#include "beam/pipette/fluid.h"

namespace zona::studies {

/// One fluid and one pulse of a vibration study.
struct VibrationCase {
  beam::Fluid fluid;             ///< its name as written in the study: "mercury", "2500 kg/m^3"
  double pulse_duration = 0;     ///< of a pulse [s]; 0 for a sine and a trace
  double angular_frequency = 0;  ///< of a sine [rad/s]

  /// "60 us", "52000 rad/s" or "trace".
  std::string pulse_label() const;
};

/// Derivatives of a tip's response by one input, all others being kept. Inputs in SI.
struct InputSensitivity {
  std::string key;       ///< of the study file, "pipette.length"; "fill.fluids" is the density
  std::string unit;      ///< of the input
  double value = 0;      ///< of the input
  double amplitude = 0;  ///< derivative of the greatest displacement [m/unit]
  /// Derivative of the greatest speed [m/s/unit]; none along the pipette, where a pulse's kinks are
  /// jumps.
  std::optional<double> peak_velocity;
  /// Derivative of the time to a tenth of the peak [s/unit]; none where the tip never gets there.
  std::optional<double> ring_down;
};

/// A response and its derivatives, the input that matters most first.
struct SensitivityResult {
  double amplitude = 0;             ///< greatest displacement, between samples, too [m]
  double peak_velocity = 0;         ///< greatest speed [m/s]
  std::optional<double> ring_down;  ///< [s]
  std::vector<InputSensitivity> inputs;
  std::vector<std::string> without;  ///< keys at a kink, where there is no derivative
};

/// Motion of the tip along the pipette, absolute.
struct AxialResult {
  double amplitude_ratio = 0;    ///< greatest displacement over the support's peak
  double peak_displacement = 0;  ///< of greatest magnitude, with its sign, towards the oocyte [m]
  double time_of_peak = 0;       ///< [s]
  beam::TipHistory history;      ///< empty when it is not to be kept
};

/// Results of a case. Displacements and velocities are absolute (fixed frame), and across the
/// pipette except in `axial`.
struct VibrationResult {
  VibrationCase setup;
  /// The lowest ones, at most ten [Hz]; in a bath each with the added mass of its own frequency.
  std::vector<double> natural_frequencies;
  /// Damping ratio of each, of the bath and the glass together.
  std::vector<double> damping_ratios;
  double amplitude_ratio = 0;        ///< Figure 5.28
  double peak_displacement = 0;      ///< of greatest magnitude, with its sign [m]
  double time_of_peak = 0;           ///< [s]
  double peak_velocity = 0;          ///< of greatest magnitude, with its sign [m/s]
  double time_of_peak_velocity = 0;  ///< [s]
  /// From the end of the pulse until the tip stays within a tenth of its peak [s]; infinite where
  /// it does not within the run.
  double ring_down = 0;
  double residual_amplitude = 0;  ///< greatest displacement in the last tenth of the run [m]
  double gain_uncertainty = 0;    ///< relative, of displacements and velocities; 0: unknown
  std::optional<SensitivityResult> sensitivities;        ///< with output.sensitivities
  std::optional<SensitivityResult> axial_sensitivities;  ///< of the motion along the pipette
  std::vector<std::string> warnings;  ///< where the bath's linear load is not valid
  /// Motion along the pipette, where the pulse is not at a right angle to it.
  std::optional<AxialResult> axial;
  beam::TipHistory history;  ///< empty when it is not to be kept
};

/// The pulse moves the tip along the pipette, too.
bool is_oblique(const std::vector<VibrationResult>& results);

/// Amplitude ratios as a table, one row per fluid and one column per pulse; "-" where there is
/// none; after an oblique pulse those along the pipette in another one.
std::string amplitude_table(const std::vector<VibrationResult>& results);

/// The warnings of the case that has most of them, and how many cases have any; empty without
/// warnings.
std::string warning_text(const std::vector<VibrationResult>& results);

}  // namespace zona::studies
