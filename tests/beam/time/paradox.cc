#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "beam/exact/pinned_beam.h"
#include "tests/beam/cases.h"

using namespace zona::beam;

namespace {

const double support_amplitude = 10e-6;

ExactPinnedBeam figure_5_26(double angular_frequency) {
  return {uniform_beam(test::pipette_with("mercury")), {support_amplitude, angular_frequency}, 400};
}

double greatest_centre_deflection(const ExactPinnedBeam& beam, double end, SupportStart start) {
  double greatest = 0;
  for (double time = 0; time < end; time += 4e-6)
    greatest = std::max(greatest, std::abs(beam.deflection(beam.beam.length / 2, time, start)));
  return greatest;
}

/// Greatest difference between the centre of the finite elements and the series.
double difference(const TipHistory& history, const ExactPinnedBeam& beam, SupportStart start) {
  double greatest = 0;
  for (std::size_t i = 0; i < history.time.size(); ++i)
    greatest =
        std::max(greatest, std::abs(history.displacement[i] -
                                    beam.deflection(beam.beam.length / 2, history.time[i], start)));
  return greatest;
}

/// Greatest difference that the elements' frequencies, too high by (i pi h / l)^4 / 1440, can make
/// at the centre: mode i rings with amplitude share A w omega / |omega^2 - w^2|, drifts in phase,
/// and the amplitude itself moves with the distance to resonance.
double frequency_error_bound(const ExactPinnedBeam& beam, int elements, double end) {
  const double w = beam.support.angular_frequency;
  double bound = 0;
  for (int i = 1; i <= beam.modes; i += 2) {
    const double omega = beam.angular_frequency(i);
    const double error = std::pow(i * M_PI / elements, 4) / 1440;
    const double distance = std::abs(omega * omega - w * w);
    const double ringing = 2 / (i * M_PI) * beam.support.amplitude * w * omega / distance;
    bound += ringing * (std::min(2., omega * end * error) +
                        std::min(2., 4 * omega * omega * error / distance));
  }
  return bound;
}

}  // namespace

TEST_CASE("(5.74) without the initial velocity of the support gives Figure 5.26") {
  const ExactPinnedBeam beam = figure_5_26(208000);
  const double printed = greatest_centre_deflection(beam, 20e-3, SupportStart::as_printed);
  // The text says 26 %. The spurious first mode alone is 2/pi A w / omega_1 = 27.1 % of the length.
  CHECK(printed / beam.beam.length == Approx(0.27).margin(0.01));
  CHECK(greatest_centre_deflection(beam, 20e-3, SupportStart::complete) <= 11e-6);
}

TEST_CASE("the printed deflection grows with the frequency, the complete one does not") {
  double previous = 0;
  for (const double w : {5200., 52000., 208000.}) {
    const ExactPinnedBeam beam = figure_5_26(w);
    const double printed = greatest_centre_deflection(beam, 10e-3, SupportStart::as_printed);
    CHECK(printed > 3 * previous);
    CHECK(greatest_centre_deflection(beam, 10e-3, SupportStart::complete) <
          1.5 * support_amplitude);
    previous = printed;
  }
}

TEST_CASE("the complete series starts at rest and follows its support") {
  const ExactPinnedBeam beam = figure_5_26(52000);
  // Away from the support nothing has moved yet; the series of 400 modes errs by 2/pi/400 of A w t.
  const double early = 1e-9;
  CHECK(std::abs(beam.deflection(beam.beam.length / 2, early, SupportStart::complete)) <
        support_amplitude * 52000 * early / 400);
  CHECK(beam.deflection(0, 1e-5, SupportStart::complete) ==
        Approx(support_amplitude * std::sin(0.52)).epsilon(1e-12));
  CHECK(std::abs(beam.deflection(beam.beam.length, 1e-5, SupportStart::complete)) < 1e-15);
}

TEST_CASE("the finite elements agree with the complete series, not with the printed one") {
  for (const double w : {5200., 52000., 208000.}) {
    CAPTURE(w);
    const ExactPinnedBeam beam = figure_5_26(w);
    Pipette pipette = test::pipette_with("mercury", 40);
    double coarse =
        difference(integrate(simply_supported(pipette), beam.support, {2e-3, 4e-6}, Modal{}), beam,
                   SupportStart::complete);
    pipette.elements = 80;
    const BeamSystem system = simply_supported(pipette);
    const TipHistory modal = integrate(system, beam.support, {2e-3, 4e-6}, Modal{});
    const double fine = difference(modal, beam, SupportStart::complete);
    // The fourth power of the element length for the modes that matter, between w and the mesh.
    CHECK(fine < coarse / 2);
    CHECK(fine < frequency_error_bound(beam, 80, 2e-3));
    CHECK(fine < 0.15 * support_amplitude);
    CHECK(difference(modal, beam, SupportStart::as_printed) > 3 * support_amplitude);

    // The other two integrators solve the same equations.
    const TipHistory newmark = integrate(system, beam.support, {2e-3, 4e-6}, Newmark{256});
    CHECK(test::greatest_difference(newmark.displacement, modal.displacement) <
          0.02 * support_amplitude);
    const TipHistory arkode = integrate(system, beam.support, {0.2e-3, 4e-6}, Arkode{1e-6, 1e-10});
    std::vector<double> start(modal.displacement.begin(),
                              modal.displacement.begin() + arkode.displacement.size());
    CHECK(test::greatest_difference(arkode.displacement, start) < 1e-3 * support_amplitude);
  }
}
