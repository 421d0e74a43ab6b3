#include "studies/measures/profiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "studies/measures/profile_table.h"
#include "studies/measures/section_table.h"
#include "studies/parameters/time_step.h"

namespace zona::studies {

namespace {

using Eigen::Vector3d;

constexpr double undivided = std::numeric_limits<double>::infinity();

std::vector<Column> columns_after(std::vector<Column> columns) {
  columns.push_back({"points", ""});
  for (const PointQuantity& quantity : point_quantities()) {
    for (Column& column : columns_of(quantity, "")) columns.push_back(column);
  }
  return columns;
}

std::vector<std::size_t> bodies_of(const Averages& averages, const TrackedBodies& bodies) {
  std::vector<std::size_t> chosen;
  if (averages.bodies) {
    for (const std::string& name : *averages.bodies) chosen.push_back(bodies.index_of(name));
    return chosen;
  }
  for (std::size_t b = 0; b < bodies.body_count(); ++b) {
    if (bodies.body(b).prescribed() == nullptr) chosen.push_back(b);
  }
  return chosen;
}

/// The layer of cells that contains a place along an axis, across the whole grid. The upper face of
/// the grid belongs to the last layer.
mpm::Box layer_around(double place, int axis, const mpm::BackgroundGrid& grid) {
  mpm::Box layer{grid.origin(), grid.upper_corner()};
  const double cell = grid.cell_size()[axis];
  const double number = std::floor((place - layer.low[axis]) / cell + 1e-9);
  layer.low[axis] += std::min(number, grid.cells()[axis] - 1.0) * cell;
  layer.high[axis] = layer.low[axis] + cell;
  return layer;
}

}  // namespace

void check_sections(const Configuration& study, const mpm::BackgroundGrid& grid,
                    const Vector3d& origin) {
  std::vector<Problem> problems;
  for (const Table& table : study.items<SectionTable>()) {
    const auto section = table.read<SectionTable>();
    const int normal = section.normal;
    const double low = grid.origin()[normal] - origin[normal];
    const double high = grid.upper_corner()[normal] - origin[normal];
    if (section.place >= low && section.place <= high) continue;
    problems.push_back(table.problem(&SectionTable::place,
                                     fmt::format("{:g} m is outside the grid, {:g} to {:g} m along "
                                                 "{}",
                                                 section.place, low, high, "xyz"[normal])));
  }
  if (!problems.empty()) throw InputError(problems);
}

Profiles::Profile Profiles::make_profile(const std::string& name, const Averages& averages,
                                         const mpm::Solver& solver, const TrackedBodies& bodies,
                                         double end) {
  Profile profile;
  profile.name = name;
  profile.bodies = bodies_of(averages, bodies);
  profile.times = averages.times.value_or(std::vector<double>{end});
  // A run ends with its last whole step, which is what a time after it gets.
  const double step = solver.step_size();
  const double last = static_cast<double>(step_count(end, step)) * step;
  for (double& time : profile.times) time = std::min(time, last);
  std::sort(profile.times.begin(), profile.times.end(), std::greater<>());
  return profile;
}

Profiles::Profile Profiles::make_slices(const Table& table, const mpm::Solver& solver,
                                        const Vector3d& origin, const TrackedBodies& bodies,
                                        double end) {
  const auto wanted = table.read<ProfileTable>();
  Profile profile = make_profile(table.name(), wanted, solver, bodies, end);
  const mpm::BackgroundGrid& grid = solver.grid();
  profile.box = wanted.in(grid, origin);
  profile.is_current = wanted.membership == Membership::current;
  profile.bin = Vector3d::Constant(undivided);
  profile.bin[wanted.axis] =
      wanted.width.value_or(static_cast<double>(wanted.cells) * grid.cell_size()[wanted.axis]);
  profile.axes = {wanted.axis};
  return profile;
}

Profiles::Profile Profiles::make_section(const Table& table, const mpm::Solver& solver,
                                         const Vector3d& origin, const TrackedBodies& bodies,
                                         double end) {
  const auto wanted = table.read<SectionTable>();
  Profile section = make_profile(table.name(), wanted, solver, bodies, end);
  const mpm::BackgroundGrid& grid = solver.grid();
  const int normal = wanted.normal;
  section.box = layer_around(origin[normal] + wanted.place, normal, grid);
  section.is_current = true;
  section.bin = grid.cell_size();
  section.bin[normal] = undivided;
  section.axes = {0, 1, 2};
  return section;
}

Profiles::Profiles(const Configuration& study, const mpm::Solver& solver, const Vector3d& origin,
                   const TrackedBodies& bodies, double end, const std::filesystem::path& directory,
                   bool is_resumed) {
  for (const Table& table : study.items<ProfileTable>())
    profiles_.profiles.push_back(make_slices(table, solver, origin, bodies, end));
  for (const Table& table : study.items<SectionTable>())
    sections_.profiles.push_back(make_section(table, solver, origin, bodies, end));
  if (!profiles_.profiles.empty()) {
    profiles_.file.emplace(directory / "profiles.csv",
                           columns_after({{"profile", ""}, {"time", "s"}, {"slice", "m"}}),
                           is_resumed);
  }
  if (!sections_.profiles.empty()) {
    sections_.file.emplace(
        directory / "sections.csv",
        columns_after({{"section", ""}, {"time", "s"}, {"x", "m"}, {"y", "m"}, {"z", "m"}}),
        is_resumed);
  }
}

bool Profiles::is_due(const mpm::Solver& solver) const {
  const double now = solver.time() + solver.step_size() / 2;
  const auto is_due = [&](const Profile& profile) {
    return !profile.times.empty() && profile.times.back() < now;
  };
  return std::any_of(profiles_.profiles.begin(), profiles_.profiles.end(), is_due) ||
         std::any_of(sections_.profiles.begin(), sections_.profiles.end(), is_due);
}

void Profiles::write_due(const mpm::Solver& solver, const TrackedBodies& bodies) {
  const double now = solver.time() + solver.step_size() / 2;
  for (Group* group : {&profiles_, &sections_}) {
    for (Profile& profile : group->profiles) {
      if (profile.times.empty() || profile.times.back() >= now) continue;
      while (!profile.times.empty() && profile.times.back() < now) profile.times.pop_back();
      write(profile, solver.time(), bodies, *group->file);
    }
  }
}

void Profiles::visit_state(mpm::StateVisitor& visitor) {
  for (auto [name, group] : {std::pair{"profiles/", &profiles_}, {"sections/", &sections_}}) {
    if (group->file) group->file->visit_state(visitor);
    for (std::size_t p = 0; p < group->profiles.size(); ++p) {
      auto left = static_cast<std::int64_t>(group->profiles[p].times.size());
      visitor.visit(name + std::to_string(p), left);
      group->profiles[p].times.resize(static_cast<std::size_t>(left));
    }
  }
}

void Profiles::write(const Profile& profile, double time, const TrackedBodies& bodies,
                     HistoryFile& file) {
  std::map<std::array<long, 3>, PointMean> bins;  // by z, y, x
  for (const std::size_t b : profile.bodies) {
    for (int id = 0; id < bodies.point_count(b); ++id) {
      const Vector3d place = profile.is_current ? bodies.place_of(b, id) : bodies.start_of(b, id);
      if (!profile.box.contains(place)) continue;
      const Vector3d bin = (place - profile.box.low).cwiseQuotient(profile.bin);
      const auto number = [&](int axis) { return std::lround(std::floor(bin[axis] + 1e-9)); };
      bins[{number(2), number(1), number(0)}].add(bodies.values(b, id));
    }
  }
  const Vector3d middle = (profile.box.low + profile.box.high) / 2;
  for (const auto& [number, sum] : bins) {
    std::vector<double> row{time};
    for (const int axis : profile.axes) {
      const bool is_divided = std::isfinite(profile.bin[axis]);
      const double bin = static_cast<double>(number[2 - axis]) + 0.5;
      row.push_back(is_divided ? profile.box.low[axis] + bin * profile.bin[axis] : middle[axis]);
    }
    const PointValues mean = sum.mean();
    row.push_back(static_cast<double>(sum.points()));
    row.insert(row.end(), mean.value.begin(), mean.value.end());
    file.add(profile.name, row);
  }
}

}  // namespace zona::studies
