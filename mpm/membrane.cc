#include "mpm/membrane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mpm/errors.h"

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

}  // namespace

Membrane::Membrane(const MembraneProperties& p, std::optional<Elastodamage> law, bool objective,
                   const MaterialPoints& points, std::vector<Triangle> triangles)
    : properties(p),
      damage_law(law),
      surface(std::move(triangles), places_of(points)),
      kinematics(make_kinematics(objective, points, surface)),
      strain(points.size(), 0.0),
      damage(points.size(), 0.0),
      integrity(points.size(), 1.0),
      failure_time(points.size(), std::numeric_limits<double>::infinity()),
      energy_density(points.size(), 0.0) {
  check(p);
  if (law && !(law->elastic_limit > 0)) {
    throw ModelError(fmt::format("the elastic limit must be positive, got {}", law->elastic_limit));
  }
  for (auto& component : stress) component.assign(points.size(), 0.0);
  const auto areas = surface.areas(points.position);
  reference_area.assign(areas.begin(), areas.end());
}

double Membrane::wave_speed() const {
  return std::sqrt(
      properties.youngs_modulus /
      (properties.density * (1 - properties.poisson_ratio * properties.poisson_ratio)));
}

void Membrane::update_stress(const std::array<Field, 3>& position, double time, int threads) {
  const int count = static_cast<int>(strain.size());
  std::vector<int> newly_failed;
  std::visit(
      [&](auto& k) {
        k.follow(position, surface, threads);
#pragma omp parallel for num_threads(threads) schedule(static)
        for (int first = 0; first < count; first += lane_count) {
          update_group(k, consecutive(first, count), time, newly_failed);
        }
      },
      kinematics);
  if (!newly_failed.empty()) drop_failed(newly_failed);
}

template <class K>
void Membrane::update_group(const K& k, const PointGroup& group, double time,
                            std::vector<int>& newly_failed) {
  const LocalStrain local = k.local_strain(group);
  const Principal e = principal(local.strain);
  group.store(strain, e.first);
  if (damage_law) grow_damage(group, e.first, time, newly_failed);
  InPlane s = membrane_stress(e, properties);
  const Lanes left = group.load(integrity);
  s = {s.xx * left, s.yy * left, s.xy * left};
  group.store(energy_density,
              0.5 * (s.xx * local.strain.xx + s.yy * local.strain.yy) + s.xy * local.strain.xy);
  constexpr int row[6] = {0, 1, 2, 0, 1, 2};
  constexpr int column[6] = {0, 1, 2, 1, 2, 0};
  const auto& [strains, x, y] = local;
  for (int c = 0; c < 6; ++c) {
    const int i = row[c];
    const int j = column[c];
    group.store(stress[c],
                s.xx * x[i] * x[j] + s.yy * y[i] * y[j] + s.xy * (x[i] * y[j] + y[i] * x[j]));
  }
}

void Membrane::grow_damage(const PointGroup& group, const Lanes& largest_strain, double time,
                           std::vector<int>& newly_failed) {
  const Lanes limit = damage_law->elastic_limit * (1.0 + group.load(damage));
  if (!any(largest_strain > limit, group.count())) return;
  for (int l = 0; l < group.count(); ++l) {
    const int p = group[l];
    if (failed(p) || !(largest_strain[l] > limit[l])) continue;
    damage[p] = damage_law->damage(largest_strain[l]);
    integrity[p] = damage_law->integrity(damage[p]);
    if (!failed(p)) continue;
    failure_time[p] = time;
#pragma omp critical
    newly_failed.push_back(p);
  }
}

void Membrane::drop_failed(std::vector<int>& newly_failed) {
  std::sort(newly_failed.begin(), newly_failed.end());
  for (int p : newly_failed) {
    ++failed_points;
    const std::vector<int> neighbours = surface.drop_triangles_of(p);
    std::visit([&](auto& k) { k.forget_failed(p, neighbours, surface); }, kinematics);
  }
}

}  // namespace zona::mpm
