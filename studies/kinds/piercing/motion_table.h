#pragma once

#include <filesystem>
#include <optional>

#include "coupling/tip_motion.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

enum class MotionKind { sine, triangle, beam, trace };

/// Along the pipette, a positive motion goes into the oocyte.
enum class MotionAxis { lateral, axial };

/// Motion of the tip of the injection pipette.
struct Motion {
  MotionKind kind;
  MotionAxis axis;
  std::optional<double> amplitude;  ///< [m]; empty: the source's
  double period;                    ///< of a sine [s]
  double duration;                  ///< of a triangle [s]
  std::filesystem::path trace;      ///< of a recorded history

  /// Amplitude of a sine or peak of a triangle: the given one, or 13.5 um and 1.8 um (5.4) [m].
  double peak() const;
  Eigen::Vector3d direction() const;
};

/// Unit vectors across the pipette and along it, into the egg.
inline const Eigen::Vector3d kLateral(0, 1, 0);
inline const Eigen::Vector3d kAxial(-1, 0, 0);

/// The part of a history that drives the tip.
struct MotionWindow {
  double scale;                        ///< factor on displacements [-]
  double ramp;                         ///< fading in [s]
  std::optional<double> window_start;  ///< [s]; empty: by auto_fraction
  double window_length;                ///< [s]
  double auto_fraction;                ///< of the peak displacement [-]
};

/// The section [motion]: of a piercing, and of a comparison, which is always driven by beams.
void declare_motion(Schema& schema);
void declare_beam_motion(Schema& schema);

/// The window of a history along an axis, for a simulation of `length` [s].
coupling::TipMotionOptions window_options(const MotionWindow& window, double length,
                                          const Eigen::Vector3d& axis);

/// The key to report for a window that does not fit its history.
std::string window_key(const Configuration& study);

}  // namespace zona::studies
