#include "mpm/bodies/body.h"

#include <fmt/format.h>

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

void Body::sort_points() {
  if (membrane()) return;
  const std::vector<int> order = cells.traversal_order();
  const auto permute = [&order](auto& values) {
    auto old = values;
    for (std::size_t p = 0; p < order.size(); ++p) values[p] = old[order[p]];
  };
  points.for_each_field(permute);
  permute(points.id);
  std::visit([&](auto& m) { m.for_each_field(permute); }, material);
  cells.renumber_in_traversal_order();
}

void Body::visit_state(StateVisitor& visitor) {
  int number = 0;
  const auto visit = [&](Field& field) {
    visitor.visit(fmt::format("bodies/{}/{:02}", name, number++), field);
  };
  points.for_each_field(visit);
  visitor.visit("bodies/" + name + "/id", points.id);
  std::visit([&](auto& m) { m.for_each_field(visit); }, material);
  if (auto* membrane = std::get_if<Membrane>(&material)) {
    if (visitor.is_restoring()) membrane->drop_all_failed();
  }
  if (auto* rigid = std::get_if<Prescribed>(&material)) {
    visitor.visit("bodies/" + name + "/reaction", rigid->reaction);
  }
}

}  // namespace zona::mpm
