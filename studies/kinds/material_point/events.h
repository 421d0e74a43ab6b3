#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "mpm/bodies/single_point.h"

namespace zona::studies {

/// Events of a point on its path (yield, peak, bifurcation, failure) and its energies.
class PointEvents {
 public:
  explicit PointEvents(const mpm::PointSample& start) : last_(start) {}

  /// The state after a step, and the greatest stress that is left in its free components [Pa].
  void add(long step, const mpm::PointSample& sample, double stress_left);

  double largest_equivalent_stress() const { return largest_; }
  nlohmann::json results() const;

 private:
  struct Event {
    long step;
    mpm::PointSample sample;
  };
  nlohmann::json bifurcation() const;

  mpm::PointSample last_;
  std::optional<Event> yield_;
  std::optional<Event> peak_;
  std::optional<Event> surface_;         ///< of decohesion, after the step in which it appears
  std::optional<Event> before_surface_;  ///< the state before that step
  std::optional<Event> failure_;
  double largest_ = 0;
  double largest_left_ = 0;
  double work_ = 0;  ///< of the stress [J/m^3]
};

}  // namespace zona::studies
