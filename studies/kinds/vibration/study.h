#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beam/motion/tip_history.h"
#include "beam/pipette/fluid.h"
#include "studies/input/configuration.h"
#include "studies/run/study_kind.h"

namespace zona::studies {

/// One fluid and one pulse of a vibration study.
struct VibrationCase {
  beam::Fluid fluid;             ///< its name as written in the study: "mercury", "2500 kg/m^3"
  double pulse_duration = 0;     ///< of a pulse [s]; 0 for a sine and a trace
  double angular_frequency = 0;  ///< of a sine [rad/s]

  /// "60 us", "52000 rad/s" or "trace".
  std::string pulse_label() const;
};

/// What the response of a tip does when one input changes, everything else being kept. Derivatives
/// are by the input in SI.
struct InputSensitivity {
  std::string key;       ///< of the study file, "pipette.length"; "fill.fluids" is the density
  std::string unit;      ///< of the input
  double value = 0;      ///< of the input
  double amplitude = 0;  ///< of the greatest displacement [m/unit]
  /// Of the greatest speed [m/s/unit]; none along the pipette, where a pulse's kinks are jumps.
  std::optional<double> peak_velocity;
  std::optional<double> ring_down;  ///< of the time to a tenth of the peak [s/unit]; none if never
};

/// A response whose derivatives are taken, and these, the one that matters most first.
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

/// What a case came to. Displacements and velocities are absolute (fixed frame), and across the
/// pipette but for `axial`.
struct VibrationResult {
  VibrationCase setup;
  /// The lowest, at most ten [Hz]; in a bath each with the added mass of its own frequency.
  std::vector<double> natural_frequencies;
  /// Damping ratio of each, of the bath and the glass together.
  std::vector<double> damping_ratios;
  double amplitude_ratio = 0;        ///< Figure 5.28
  double peak_displacement = 0;      ///< of greatest magnitude, with its sign [m]
  double time_of_peak = 0;           ///< [s]
  double peak_velocity = 0;          ///< of greatest magnitude, with its sign [m/s]
  double time_of_peak_velocity = 0;  ///< [s]
  /// From the end of the pulse until the tip stays within a tenth of its peak [s]; the end of the
  /// run counts as never: then it is infinite.
  double ring_down = 0;
  double residual_amplitude = 0;  ///< greatest displacement in the last tenth of the run [m]
  double gain_uncertainty = 0;    ///< relative, of displacements and velocities; 0: none is known
  std::optional<SensitivityResult> sensitivities;        ///< where they are wanted
  std::optional<SensitivityResult> axial_sensitivities;  ///< of the motion along the pipette
  std::vector<std::string> warnings;  ///< where the bath's linear load does not hold
  /// Of the motion along the pipette, where the pulse is not at a right angle to it.
  std::optional<AxialResult> axial;
  beam::TipHistory history;  ///< empty when it is not to be kept
};

/// All fluids with all pulses, fluid by fluid, in the order of the study.
std::vector<VibrationCase> vibration_cases(const Configuration& study);

/// Computes the cases in parallel; the results are in the order of the cases and do not depend on
/// the number of threads. After an interrupt the cases not begun are left out.
std::vector<VibrationResult> compute_vibration(const Configuration& study, Session& session);

/// Amplitude ratios as a table, one row per fluid and one column per pulse; "-" where there is
/// none; after an oblique pulse those along the pipette in another one.
std::string amplitude_table(const std::vector<VibrationResult>& results);

/// Checks the pipettes; the job writes amplitudes.csv (a row per case), history.csv (time and one
/// column of tip displacement per case) if wanted, the results and the table.
Job prepare_vibration(const Configuration& study);

/// The size of the study in one line.
StudyCost estimate_vibration(const Configuration& study);

/// How long the cases will take here, from trying the first one.
std::string try_vibration(const Configuration& study, int threads);

}  // namespace zona::studies
