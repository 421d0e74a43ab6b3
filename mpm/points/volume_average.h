#pragma once

#include "mpm/points/material_points.h"

namespace zona::mpm {

/// Mean of value(PointGroup), a Lanes, over the points [begin, end) of a cell, by their present
/// volume.
template <class Material, class Value>
inline double volume_average(const Material& material, const MaterialPoints& points,
                             const int* begin, const int* end, Value value) {
  double sum = 0;
  double volume = 0;
  for_each_group(begin, end, [&](const PointGroup& group) {
    const Lanes v = material.volume(group, group.load(points.mass));
    const Lanes part = v * value(group);
    for (int l = 0; l < group.count(); ++l) {
      sum += part[l];
      volume += v[l];
    }
  });
  return sum / volume;
}

}  // namespace zona::mpm
