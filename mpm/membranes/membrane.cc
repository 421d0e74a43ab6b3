#include "mpm/membranes/membrane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mpm/points/errors.h"

namespace zona::mpm {

namespace {

std::vector<Eigen::Vector3d> places_of(const MaterialPoints& points) {
  std::vector<Eigen::Vector3d> places;
  for (int p = 0; p < points.size(); ++p) places.push_back(points.position_of(p));
  return places;
}

MembraneKinematics make_kinematics(bool objective, const MaterialPoints& points, Surface& surface) {
  if (objective) return DeformationGradientKinematics(points, surface);
  return SummedStrainKinematics(points, surface);
}

void check(const MembraneProperties& p) {
  if (!(p.density > 0) || !(p.thickness > 0) || !(p.youngs_modulus > 0)) {
    throw ModelError(
        fmt::format("a membrane needs positive density, thickness and Young's modulus, got {} "
                    "kg/m^3, {} m, {} Pa",
                    p.density, p.thickness, p.youngs_modulus));
  }
  if (!(p.poisson_ratio > -1 && p.poisson_ratio < 1)) {
    throw ModelError(fmt::format("a membrane's Poisson ratio must lie between -1 and 1, got {}",
                                 p.poisson_ratio));
  }
}

Membrane::State make_state(const MembraneLaw& law, int points) {
  return std::visit(
      [&](const auto& l) -> Membrane::State {
        return MembraneState<std::decay_t<decltype(l)>>(l, points);
      },
      law);
}

}  // namespace

Membrane::Membrane(const MembraneProperties& p, const MembraneLaw& law, bool objective,
                   const MaterialPoints& points, std::vector<Triangle> triangles)
    : properties(p),
      surface(std::move(triangles), places_of(points)),
      kinematics(make_kinematics(objective, points, surface)),
      state(make_state(law, points.size())),
      integrity(points.size()),
      strain(points.size(), 0.0),
      energy_density(points.size(), 0.0) {
  check(p);
  for (auto& component : stress) component.assign(points.size(), 0.0);
  const auto areas = surface.areas(points.position);
  reference_area.assign(areas.begin(), areas.end());
}

double Membrane::wave_speed() const {
  return std::sqrt(properties.moduli().plane_stress() / properties.density);
}

void Membrane::update_stress(const std::array<Field, 3>& position, double time, int threads) {
  const int count = static_cast<int>(strain.size());
  integrity.time = time;
  std::visit(
      [&](auto& k, auto& s) {
        k.prepare(position, surface, threads);
#pragma omp parallel for num_threads(threads) schedule(static)
        for (int first = 0; first < count; first += lane_count) {
          const PointGroup group = consecutive(first, count);
          k.follow(group, position, surface);
          update_group(k, s, group);
        }
      },
      kinematics, state);
  if (!integrity.newly_failed.empty()) drop_failed();
}

template <class Kinematics, class LawState>
void Membrane::update_group(const Kinematics& k, LawState& law_state, const PointGroup& group) {
  const LocalStrain local = k.local_strain(group);
  const Principal e = principal(local.strain);
  group.store(strain, e.first);
  const auto [s, elastic] = law_state.respond(group, local, e, properties, integrity);
  group.store(energy_density, 0.5 * contract(s, elastic));
  constexpr int row[6] = {0, 1, 2, 0, 1, 2};
  constexpr int column[6] = {0, 1, 2, 1, 2, 0};
  const VectorLanes& x = local.x;
  const VectorLanes& y = local.y;
  for (int c = 0; c < 6; ++c) {
    const int i = row[c];
    const int j = column[c];
    group.store(stress[c],
                s.xx * x[i] * x[j] + s.yy * y[i] * y[j] + s.xy * (x[i] * y[j] + y[i] * x[j]));
  }
}

void Membrane::drop_failed() {
  auto& failed = integrity.newly_failed;
  std::sort(failed.begin(), failed.end());
  for (int p : failed) drop(p);
  failed.clear();
}

void Membrane::drop_all_failed() {
  failed_points = 0;
  std::vector<std::pair<double, int>> failures;  // sorted by time
  for (int p = 0; p < static_cast<int>(strain.size()); ++p) {
    if (failed(p)) failures.emplace_back(integrity.failure_time[p], p);
  }
  std::sort(failures.begin(), failures.end());
  for (const auto& failure : failures) drop(failure.second);
}

void Membrane::drop(int p) {
  ++failed_points;
  const std::vector<int> neighbours = surface.drop_triangles_of(p);
  std::visit([&](auto& k) { k.forget_failed(p, neighbours, surface); }, kinematics);
}

}  // namespace zona::mpm
