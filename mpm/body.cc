#include "mpm/body.h"

namespace zona::mpm {

bool Body::can_average() const {
  return std::visit([](const auto& m) { return can_average_volume<std::decay_t<decltype(m)>>; },
                    material);
}

double Body::wave_speed() const {
  return std::visit([](const auto& m) { return m.wave_speed(); }, material);
}

double Body::shear_wave_speed() const {
  return std::visit([](const auto& m) { return m.shear_wave_speed(); }, material);
}

void Body::reorder_as_walked() {
  if (membrane()) return;
  const std::vector<int> order = cells.walking_order();
  const auto permute = [&order](auto& values) {
    auto old = values;
    for (std::size_t p = 0; p < order.size(); ++p) values[p] = old[order[p]];
  };
  points.for_each_field(permute);
  permute(points.id);
  std::visit(
      [&](auto& m) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(m)>, Membrane>)
          m.for_each_field(permute);
      },
      material);
  cells.renumber_as_walked();
}

}  // namespace zona::mpm
