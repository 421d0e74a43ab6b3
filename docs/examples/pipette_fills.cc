// A piezo pulse shoves the shank of an injection pipette aside and back. How far does the tip
// swing, and what does the fluid in the bore change?
//
// This needs zona::beam alone. All quantities are in SI units.
#include <cmath>
#include <cstdio>

#include "beam/exact/cantilever.h"
#include "beam/motion/support_motion.h"
#include "beam/motion/tip_history.h"
#include "beam/pipette/fluid.h"
#include "beam/pipette/pipette.h"
#include "beam/system/beam_system.h"
#include "beam/system/natural_modes.h"
#include "beam/time/integrate.h"

using namespace zona::beam;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int shown_modes = 3;

// Prints one fill and says whether the finite elements agree with the modes of the exact solution.
bool report(const char* fill, double peak, const SupportMotion& pulse, const Sampling& sampling) {
  Pipette pipette;  // the glass tube of Tables 5.5 and 5.6: 10 mm long, 10 um wide, empty
  pipette.fill_density = named_fluid(fill).density;
  pipette.elements = 80;
  // A little damping in the glass, which the source has not: it takes the highest modes, of which
  // the pulse stirs all, and leaves the lowest (1e-7 s: a mode of 10 kHz decays in 5 ms).
  pipette.damping_beta = 1e-7;

  // In space the pipette is Hermite elements, in coordinates relative to its moving support.
  // Assembling them is what loads deal.II; whatever follows is small banded matrices.
  const BeamSystem system = cantilever(pipette);

  // In time nothing has to be approximated: the pulse is straight between its kinks, so that each
  // mode rings freely from kink to kink. `Newmark` and `Arkode` do the same by steps.
  const TipHistory tip = integrate(system, pulse, sampling, Modal{});
  const double ratio = amplitude_ratio(tip, peak);

  // The exact solution shares nothing with the elements. Its error is the modes left out.
  const ExactCantilever exact(uniform_beam(pipette), 500);
  const RayleighDamping damping{pipette.damping_alpha, pipette.damping_beta};
  const double exact_ratio = amplitude_ratio(exact.tip_history(pulse, sampling, damping), peak);
  std::printf("%-10s amplitude %.4f, exact %.4f\n", fill, ratio, exact_ratio);

  // Elements too coarse for a mode let it travel too fast: its frequency is too high by
  // (root / elements)^4 / 1440, 6e-8 for the third mode here. The amplitude is the peak of many
  // modes together and off by half a percent with 40 elements, a tenth of that with 80.
  bool agrees = std::abs(ratio / exact_ratio - 1) < 2e-3;
  const Eigen::VectorXd frequency = natural_modes(system).frequency();
  for (int mode = 1; mode <= shown_modes; ++mode) {
    const double exact_frequency = exact.angular_frequency(mode) / (2 * pi);
    std::printf("%-10s mode %d %10.4f Hz, exact %10.4f Hz\n", "", mode, frequency(mode - 1),
                exact_frequency);
    agrees = agrees && std::abs(frequency(mode - 1) / exact_frequency - 1) < 1e-6;
  }
  return agrees;
}

}  // namespace

int main() {
  const double peak = 17.9e-6;
  const SupportMotion pulse = triangular_pulse(peak, 120e-6);  // up and down in 120 us
  const Sampling sampling{5e-3, 0.6e-6};                       // 5 ms, sampled each 0.6 us

  bool agrees = true;
  for (const char* fill : {"water", "mercury"}) {
    agrees = report(fill, peak, pulse, sampling) && agrees;
  }
  if (!agrees) std::puts("The elements are farther from the exact solution than they should be.");
  return agrees ? 0 : 1;
}
