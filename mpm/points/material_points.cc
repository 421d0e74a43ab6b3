#include "mpm/points/material_points.h"

#include <numeric>

namespace zona::mpm {

std::vector<int> MaterialPoints::storage_by_id() const {
  std::vector<int> stored(id.size());
  for (int p = 0; p < size(); ++p) stored[id[p]] = p;
  return stored;
}

MaterialPoints make_points(const std::vector<Eigen::Vector3d>& places,
                           const std::vector<double>& mass, const Eigen::Vector3d& velocity) {
  MaterialPoints points;
  points.for_each_field([&](Field& field) { field.resize(places.size()); });
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (int axis = 0; axis < 3; ++axis) {
      points.position[axis][p] = places[p][axis];
      points.velocity[axis][p] = velocity[axis];
    }
    points.mass[p] = mass[p];
  }
  points.last_position = points.position;
  points.id.resize(places.size());
  std::iota(points.id.begin(), points.id.end(), 0);
  return points;
}

}  // namespace zona::mpm
