#include "studies/references/inflated_disc.h"

#include <algorithm>
#include <cmath>

#include "studies/references/hencky_membrane.h"
#include "studies/references/require.h"

namespace zona::studies::references {

using Eigen::VectorXd;

InflatedDisc inflate_disc(const MembraneLaw& law, double radius, double pressure, int elements) {
  require(elements >= 4, "a disc needs four elements or more");
  const int n = elements;
  // Hencky's deflection at a load where his theory holds, then in steps.
  PressurisedDisc small{radius, law.thickness, law.youngs_modulus,
                        std::clamp(law.poisson_ratio, 0.0, 0.5), pressure};
  int doublings = 0;
  for (; small.load() > 2e-3; ++doublings) small.pressure *= 0.5;
  const HenckyMembrane guess(small);
  Meridian meridian;
  meridian.law = law;
  meridian.reference = VectorXd::Zero(2 * n + 2);
  MeridianState state;
  state.position = meridian.reference;
  MeridianLoads loads;
  int count = 0;
  for (int i = 0; i <= n; ++i) {
    const double r = radius * (n - i) / n;
    meridian.reference[2 * i] = state.position[2 * i] = r;
    state.position[2 * i + 1] = guess.deflection(r);
    const bool edge = i == 0, axis = i == n;
    loads.unknown.push_back(edge || axis ? -1 : count++);
    loads.unknown.push_back(edge ? -1 : count++);
  }
  follow_equilibrium(
      meridian, loads, state,
      [&](double share, MeridianLoads& at) {
        at.pressure = pressure * std::pow(0.5, doublings * (1 - share));
      },
      0.5 / std::max(doublings, 1));
  return {state.position[2 * n + 1], stretch_at(meridian, state.position, n - 1).along,
          stretch_at(meridian, state.position, 0).along, enclosed_volume(state.position), state};
}

}  // namespace zona::studies::references
