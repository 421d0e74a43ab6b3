#pragma once

#include <filesystem>
#include <optional>

#include "studies/configuration.h"
#include "studies/history_file.h"
#include "studies/tracked_bodies.h"

namespace zona::studies {

/// All [[profile]] tables of a scene and the file profiles.csv, which is there when there is one.
class SceneProfiles {
 public:
  SceneProfiles(const Configuration& study, const mpm::Solver& solver, const TrackedBodies& bodies,
                const std::filesystem::path& directory, bool goes_on);

  /// Whether `write_due` would write something.
  bool is_due(const mpm::Solver& solver) const;
  /// Writes the profiles whose time is nearest to now; call it at the start and after every step.
  void write_due(const mpm::Solver& solver, const TrackedBodies& bodies);
  void visit_state(mpm::StateVisitor& visitor);

 private:
  struct Profile {
    std::string name;
    int axis;
    double start;  ///< where the first slice begins [m]
    double width;  ///< [m]
    mpm::Box box;
    bool is_current;
    std::vector<std::size_t> bodies;
    std::vector<double> times;  ///< still to come, the last one first [s]
  };

  Profile make_profile(const Table& table, const mpm::Solver& solver,
                       const TrackedBodies& bodies) const;
  void write(const Profile& profile, double time, const TrackedBodies& bodies);

  std::vector<Profile> profiles_;
  std::optional<HistoryFile> file_;
};

}  // namespace zona::studies
