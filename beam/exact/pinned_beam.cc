#include "beam/exact/pinned_beam.h"

#include <cmath>

namespace zona::beam {

double ExactPinnedBeam::angular_frequency(int mode) const {
  const double wave_number = mode * M_PI / beam.length;
  return wave_number * wave_number * beam.dispersion();
}

double ExactPinnedBeam::deflection(double x, double time, SupportStart start) const {
  const double w = support.angular_frequency;
  const double A = support.amplitude;
  double relative = 0;
  for (int mode = 1; mode <= modes; ++mode) {
    const double omega = angular_frequency(mode);
    // 2/l times the integral of (1 - x/l) sin(i pi x / l); (5.74) lacks the factor 2/l.
    const double share = 2 / (mode * M_PI);
    // Duhamel's integral of g'' = -A w^2 sin(w t') against sin(omega (t - t')).
    const double duhamel = -A * w * w * (omega * std::sin(w * time) - w * std::sin(omega * time)) /
                           (omega * omega - w * w);
    const double start_velocity = start == SupportStart::complete ? A * w : 0;
    relative -= share / omega * std::sin(mode * M_PI * x / beam.length) *
                (duhamel + start_velocity * std::sin(omega * time));
  }
  return relative + (1 - x / beam.length) * A * std::sin(w * time);
}

}  // namespace zona::beam
