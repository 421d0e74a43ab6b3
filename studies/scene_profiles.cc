#include "studies/scene_profiles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "studies/scene_shape.h"
#include "studies/solver_march.h"

namespace zona::studies {

namespace {

std::vector<Column> profile_columns() {
  std::vector<Column> columns{{"profile", ""}, {"time", "s"}, {"slice", "m"}, {"points", ""}};
  for (const PointQuantity& quantity : point_quantities()) {
    for (Column& column : columns_of(quantity, "")) columns.push_back(column);
  }
  return columns;
}

}  // namespace

SceneProfiles::SceneProfiles(const Configuration& study, const mpm::Solver& solver,
                             const TrackedBodies& bodies, const std::filesystem::path& directory,
                             bool goes_on) {
  for (const Table& table : study.items("profile")) {
    profiles_.push_back(make_profile(table, solver, bodies));
  }
  if (!profiles_.empty()) file_.emplace(directory / "profiles.csv", profile_columns(), goes_on);
}

SceneProfiles::Profile SceneProfiles::make_profile(const Table& table, const mpm::Solver& solver,
                                                   const TrackedBodies& bodies) const {
  Profile profile;
  profile.name = table.name();
  profile.axis = table.choice("axis")[0] - 'x';
  profile.box = box_of(table, solver.grid());
  profile.start = profile.box.low[profile.axis];
  profile.width = table.is_auto("width") ? static_cast<double>(table.integer("cells")) *
                                               solver.grid().cell_size()[profile.axis]
                                         : table.quantity("width");
  profile.is_current = table.choice("membership") == "current";
  if (table.is_auto("bodies")) {
    for (std::size_t b = 0; b < solver.bodies().size(); ++b) {
      if (solver.bodies()[b].prescribed() == nullptr) profile.bodies.push_back(b);
    }
  } else {
    for (const std::string& name : table.texts("bodies")) {
      profile.bodies.push_back(bodies.index_of(name));
    }
  }
  profile.times = table.is_auto("times") ? std::vector<double>{table.study().quantity("time.end")}
                                         : table.quantities("times");
  // A run ends with its last whole step, which is what a time after it gets.
  const double step = solver.step_size();
  const double last =
      static_cast<double>(step_count(table.study().quantity("time.end"), step)) * step;
  for (double& time : profile.times) time = std::min(time, last);
  std::sort(profile.times.begin(), profile.times.end(), std::greater<>());
  return profile;
}

bool SceneProfiles::is_due(const mpm::Solver& solver) const {
  const double now = solver.time() + solver.step_size() / 2;
  return std::any_of(profiles_.begin(), profiles_.end(), [&](const Profile& profile) {
    return !profile.times.empty() && profile.times.back() < now;
  });
}

void SceneProfiles::write_due(const mpm::Solver& solver, const TrackedBodies& bodies) {
  const double now = solver.time() + solver.step_size() / 2;
  for (Profile& profile : profiles_) {
    if (profile.times.empty() || profile.times.back() >= now) continue;
    while (!profile.times.empty() && profile.times.back() < now) profile.times.pop_back();
    write(profile, solver.time(), bodies);
  }
}

void SceneProfiles::visit_state(mpm::StateVisitor& visitor) {
  if (file_) file_->visit_state(visitor);
  for (std::size_t p = 0; p < profiles_.size(); ++p) {
    auto left = static_cast<std::int64_t>(profiles_[p].times.size());
    visitor.visit("profiles/" + std::to_string(p), left);
    profiles_[p].times.resize(static_cast<std::size_t>(left));
  }
}

void SceneProfiles::write(const Profile& profile, double time, const TrackedBodies& bodies) {
  std::map<long, PointMean> slices;
  for (const std::size_t b : profile.bodies) {
    for (int id = 0; id < bodies.point_count(b); ++id) {
      const Eigen::Vector3d place =
          profile.is_current ? bodies.place_of(b, id) : bodies.start_of(b, id);
      if (!profile.box.contains(place)) continue;
      const double slice = (place[profile.axis] - profile.start) / profile.width;
      slices[std::lround(std::floor(slice + 1e-9))].add(bodies.values(b, id));
    }
  }
  for (const auto& [number, sum] : slices) {
    const double middle = profile.start + (static_cast<double>(number) + 0.5) * profile.width;
    const PointValues mean = sum.mean();
    std::vector<double> row{time, middle, static_cast<double>(sum.points())};
    row.insert(row.end(), mean.value.begin(), mean.value.end());
    file_->add(profile.name, row);
  }
}

}  // namespace zona::studies
