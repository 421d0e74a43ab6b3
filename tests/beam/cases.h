#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "beam/exact/cantilever.h"
#include "beam/pipette/fluid.h"
#include "beam/system/beam_system.h"
#include "beam/time/integrate.h"

namespace zona::beam::test {

/// Table 5.7 by name.
inline Pipette pipette_with(const std::string& fluid, int elements = 20) {
  Pipette pipette;
  pipette.fill_density = named_fluid(fluid).density;
  pipette.fill_viscosity = named_fluid(fluid).viscosity;
  pipette.elements = elements;
  return pipette;
}

/// One point of Figure 5.28.
struct PulseCase {
  std::string fluid;
  double duration;  ///< [s]
};

inline std::vector<PulseCase> figure_5_28() {
  std::vector<PulseCase> cases;
  for (const char* fluid : {"none", "water", "fluorinert", "mercury"})
    for (int duration = 60; duration <= 600; duration += 60)
      cases.push_back({fluid, duration * 1e-6});
  return cases;
}

inline double greatest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double greatest = a.size() == b.size() ? 0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    greatest = std::max(greatest, std::abs(a[i] - b[i]));
  return greatest;
}

/// Greatest relative error of viscous loads interpolated between radii.
inline double interpolation_error(const std::vector<ViscousLoad>& loads) {
  double greatest = 0;
  for (double radius = loads.front().radius; radius < loads.back().radius; radius *= 1.1)
    for (double omega = 100; omega < 1e7; omega *= 3) {
      std::complex<double> sum = 0;
      for (const ViscousLoad& load : loads) {
        double share = 1;
        for (const ViscousLoad& other : loads)
          if (&other != &load)
            share *= std::log(radius / other.radius) / std::log(load.radius / other.radius);
        sum += share * viscous_load(load.flow, load.liquid, load.radius, {0, omega});
      }
      const auto exact = viscous_load(loads.front().flow, loads.front().liquid, radius, {0, omega});
      greatest = std::max(greatest, std::abs(sum / exact - 1.));
    }
  return greatest;
}

/// Bound on the difference of two solutions for the tip whose modes differ in frequency by a
/// relative amount: after a kink each mode rings with the amplitude share * jump / omega, and the
/// difference of two sines is their phase error, at most 2. `relative_error` takes omega and
/// alpha_n L.
template <class RelativeError>
double phase_error_bound(const ExactCantilever& exact, const SupportMotion& motion, double end,
                         RelativeError&& relative_error) {
  double bound = 0;
  for (const Kink& kink : kinks(motion))
    for (int mode = 1; mode <= exact.modes(); ++mode) {
      const double omega = exact.angular_frequency(mode);
      const double phase = omega * (end - kink.time) * relative_error(omega, exact.root(mode));
      bound += std::abs(exact.tip_share(mode) * kink.velocity_jump) / omega * std::min(2., phase);
    }
  return bound;
}

}  // namespace zona::beam::test
