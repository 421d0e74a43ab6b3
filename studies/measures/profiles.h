#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "studies/input/configuration.h"
#include "studies/measures/averages.h"
#include "studies/measures/tracked_bodies.h"
#include "studies/run/history_file.h"

namespace zona::studies {

/// Throws InputError where the plane of a [[section]] misses the grid. Places in the tables count
/// from `origin` [m].
void check_sections(const Configuration& study, const mpm::BackgroundGrid& grid,
                    const Eigen::Vector3d& origin);

/// All [[profile]] and [[section]] tables of a study: means over bins of points at chosen times,
/// written to profiles.csv and sections.csv. A file exists only where the study has such a table.
class Profiles {
 public:
  /// Places in the tables count from `origin` [m]; the run lasts until `end` [s].
  Profiles(const Configuration& study, const mpm::Solver& solver, const Eigen::Vector3d& origin,
           const TrackedBodies& bodies, double end, const std::filesystem::path& directory,
           bool is_resumed);

  /// `write_due` would write something.
  bool is_due(const mpm::Solver& solver) const;
  /// Writes the profiles whose time has come, give or take half a step; call it at the start and
  /// after every step.
  void write_due(const mpm::Solver& solver, const TrackedBodies& bodies);
  void visit_state(mpm::StateVisitor& visitor);

 private:
  struct Profile {
    std::string name;
    mpm::Box box;  ///< only points in it count
    bool is_current;
    std::vector<std::size_t> bodies;
    std::vector<double> times;  ///< still to come, the last one first [s]
    /// Widths of a bin along the axes; infinite where the box is not divided [m]. Bins start at the
    /// lower corner of the box.
    Eigen::Vector3d bin;
    std::vector<int> axes;  ///< along which the middle of a bin is written
  };
  /// All profiles or all sections, and their file.
  struct Group {
    std::vector<Profile> profiles;
    std::optional<HistoryFile> file;
  };

  static Profile make_profile(const std::string& name, const Averages& averages,
                              const mpm::Solver& solver, const TrackedBodies& bodies, double end);
  static Profile make_slices(const Table& table, const mpm::Solver& solver,
                             const Eigen::Vector3d& origin, const TrackedBodies& bodies,
                             double end);
  static Profile make_section(const Table& table, const mpm::Solver& solver,
                              const Eigen::Vector3d& origin, const TrackedBodies& bodies,
                              double end);
  static void write(const Profile& profile, double time, const TrackedBodies& bodies,
                    HistoryFile& file);

  Group profiles_;
  Group sections_;
};

}  // namespace zona::studies
