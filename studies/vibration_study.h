#pragma once

#include <string>
#include <vector>

#include "beam/tip_history.h"
#include "studies/configuration.h"
#include "studies/study_kinds.h"

namespace zona::studies {

/// One fluid and one pulse of a vibration study.
struct VibrationCase {
  std::string fluid;             ///< as written in the study: "mercury", "2500 kg/m^3"
  double fluid_density = 0;      ///< [kg/m^3]
  double pulse_duration = 0;     ///< of a triangular pulse [s]
  double angular_frequency = 0;  ///< of a sine [rad/s]

  /// "60 us" or "52000 rad/s".
  std::string pulse_label() const;
};

/// What a case came to. Displacements and velocities are absolute (fixed frame).
struct VibrationResult {
  VibrationCase setup;
  std::vector<double> natural_frequencies;  ///< the lowest, at most ten [Hz]
  double amplitude_ratio = 0;               ///< Figure 5.28
  double peak_displacement = 0;             ///< of greatest magnitude, with its sign [m]
  double time_of_peak = 0;                  ///< [s]
  double peak_velocity = 0;                 ///< of greatest magnitude, with its sign [m/s]
  double time_of_peak_velocity = 0;         ///< [s]
  beam::TipHistory history;                 ///< empty when it is not to be kept
};

/// All fluids with all pulses, fluid by fluid, in the order of the study.
std::vector<VibrationCase> vibration_cases(const Configuration& study);

/// Computes the cases in parallel; the results are in the order of the cases and do not depend on
/// the number of threads. After an interrupt the cases not begun are left out.
std::vector<VibrationResult> compute_vibration(const Configuration& study, Session& session);

/// Amplitude ratios as a table, one row per fluid and one column per pulse; "-" where there is
/// none.
std::string amplitude_table(const std::vector<VibrationResult>& results);

/// Checks the pipettes; the job writes amplitudes.csv (a row per case), history.csv (time and one
/// column of tip displacement per case) if wanted, the results and the table.
Job prepare_vibration(const Configuration& study);

/// The size of the study in one line.
StudyCost estimate_vibration(const Configuration& study);

/// How long the cases will take here, from trying the first one.
std::string try_vibration(const Configuration& study, int threads);

}  // namespace zona::studies
