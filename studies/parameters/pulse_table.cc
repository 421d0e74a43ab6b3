#include "studies/parameters/pulse_table.h"

#include <fmt/format.h>

#include <cmath>

#include "coupling/tip_trace.h"
#include "studies/input/with_key.h"

namespace zona::studies {

namespace {

Words<PulseShape> pulse_shapes(bool with_sine) {
  Words<PulseShape> shapes{{"triangular", PulseShape::triangular},
                           {"trapezoid", PulseShape::trapezoid},
                           {"half_sine", PulseShape::half_sine},
                           {"trace", PulseShape::trace}};
  if (with_sine) shapes.push_back({"sine", PulseShape::sine});
  return shapes;
}

void check_shape(const Configuration& study, const Complain& complain) {
  const PulseShape shape = study.value(&Pulse::shape);
  const std::string trace_key = study.key(&Pulse::trace);
  if (shape == PulseShape::trace && study.value(&Pulse::trace).empty())
    complain(trace_key,
             fmt::format("is missing; {} = \"trace\" needs the path of a CSV file; write "
                         "e.g. {} = \"support.csv\"",
                         study.key(&Pulse::shape), trace_key));
  if (shape == PulseShape::sine && study.value(&Pulse::count) > 1)
    complain(study.key(&Pulse::count), "a sine does not end; trains are made of the other shapes");
}

beam::SupportMotion single_pulse(const Configuration& study, const Pulse& pulse, double duration) {
  const double peak = pulse.support_peak();
  switch (pulse.shape) {
    case PulseShape::trapezoid:
      return beam::trapezoidal_pulse(peak, duration, duration * pulse.rise_fraction);
    case PulseShape::half_sine:
      return beam::half_sine_pulse(peak, duration);
    case PulseShape::trace:
      return with_key(study, study.key(&Pulse::trace), [&] {
        const auto trace = coupling::read_tip_trace_csv(pulse.trace.string());
        const beam::SupportMotion motion = beam::SampledMotion{trace.time, trace.displacement};
        beam::check(motion);
        return motion;
      });
    case PulseShape::triangular:
    case PulseShape::sine:
      break;
  }
  return beam::triangular_pulse(peak, duration);
}

void declare_displacement(TableKeys<Pulse>& keys, bool with_sine) {
  const std::string sine = with_sine ? ", or a sine that starts at once (Figure 5.26)" : "";
  keys.choice("shape", &Pulse::shape, pulse_shapes(with_sine))
      .doc(
          "Form of the support's displacement: up and down at constant speed (Figure 5.27); up, "
          "held and down; half a period of a sine; a recorded trace" +
          sine + ".");
  keys.quantity("peak", &Pulse::peak, "m", "17.9 um")
      .in("(0, 0.01]")
      .or_auto()
      .doc(
          "Peak displacement of the support. Not given in the source; 17.9 um moves the tip of the "
          "mercury-filled pipette by its 13.5 um (5.4) when the beam is resolved (80 elements). "
          "\"auto\" is voltage times gain.");
  keys.quantity("angle", &Pulse::angle, "rad", "90 deg")
      .in("[0, 1.5708]")
      .doc(
          "Angle between the support's motion and the pipette's axis: 90 deg is across, as the "
          "source has it, 0 deg along, towards the oocyte. Between them the tip moves as a beam "
          "after the pulse times the sine and, along itself, as a rod after the pulse times the "
          "cosine.");
}

void declare_controller(TableKeys<Pulse>& keys) {
  keys.quantity("voltage", &Pulse::voltage, "V", "10 V")
      .in("(0, 1000]")
      .doc("Setting of the controller; used where peak = \"auto\".");
  keys.quantity("gain", &Pulse::gain, "m/V", "1.79 um/V")
      .in("(0, 1e-3]")
      .doc(
          "Support displacement per voltage of the controller. The source calls this relation "
          "unknown; 1.79 um/V is its 13.5 um of the tip at 10 V.");
  keys.number("gain_uncertainty", &Pulse::gain_uncertainty, 0.5)
      .in("[0, 1)")
      .doc(
          "Relative uncertainty of the gain: displacements scale with it, so results that scale "
          "are reported with this interval where peak = \"auto\".");
}

void declare_course(TableKeys<Pulse>& keys) {
  keys.number("rise_fraction", &Pulse::rise_fraction, 0.25)
      .in("(0, 0.5]")
      .doc("Fraction of a trapezoid's duration for its rise, and for its fall.");
  keys.integer("count", &Pulse::count, 1)
      .in("[1, 100000]")
      .doc("Number of pulses in a train; not for a sine.");
  keys.quantity("repetition_rate", &Pulse::repetition_rate, "Hz", "100 Hz")
      .in("(0, 1e6]")
      .doc("Rate of the pulses in a train.");
  keys.file("trace", &Pulse::trace, "")
      .doc(
          "CSV file of a measured motion of the support, `time [us], displacement [um]`, from 0; "
          "needed by shape = \"trace\", which takes peaks and times from it.");
}

}  // namespace

void declare_pulse(Schema& schema, bool with_sine) {
  TableKeys<Pulse> keys(schema, "pulse");
  declare_displacement(keys, with_sine);
  declare_controller(keys);
  declare_course(keys);
  schema.check(check_shape);
}

void declare_pulse_duration(Schema& schema) {
  TableKeys<PulseDuration> keys(schema, "pulse");
  keys.quantity("duration", &PulseDuration::duration, "s", "60 us")
      .in("(0, 1]")
      .doc("Duration of the pulse (5.4).");
}

PulseDirection Pulse::direction() const {
  constexpr double rounding = 1e-12;  // of a right angle in radians
  if (std::abs(std::cos(angle)) < rounding) return {1, 0};
  return {std::sin(angle), std::cos(angle)};
}

std::string Pulse::calibration_text() const {
  if (peak) return "";
  const double mean = support_peak();
  return fmt::format(
      "support: {:g} V times {:g} um/V is {:.4g} um, by the gain's uncertainty {:.4g} to {:.4g} "
      "um; displacements scale with it\n",
      voltage, gain * 1e6, mean * 1e6, mean * (1 - gain_uncertainty) * 1e6,
      mean * (1 + gain_uncertainty) * 1e6);
}

beam::SupportMotion support_motion(const Configuration& study, double duration) {
  const Pulse pulse = study.read<Pulse>();
  const beam::SupportMotion single = single_pulse(study, pulse, duration);
  if (pulse.count == 1) return single;
  return with_key(study, study.key(&Pulse::repetition_rate), [&] {
    return beam::pulse_train(single, pulse.count, 1 / pulse.repetition_rate);
  });
}

beam::SupportMotion support_motion(const Configuration& study) {
  return support_motion(study, study.value(&PulseDuration::duration));
}

}  // namespace zona::studies
