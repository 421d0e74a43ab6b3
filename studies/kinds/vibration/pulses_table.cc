#include "studies/kinds/vibration/pulses_table.h"

#include "studies/parameters/bath_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pulse_table.h"

namespace zona::studies {

namespace {

const Words<Supports> kSupports{{"clamped", Supports::clamped}, {"pinned", Supports::pinned}};

void check_direction(const Configuration& study, const Complain& complain) {
  Pulse pulse{};
  pulse.angle = study.value(&Pulse::angle);
  if (pulse.direction().along == 0 || study.value(&Support::supports) == Supports::clamped) return;
  complain(study.key(&Pulse::angle),
           "a simply supported beam can only be moved across its axis; needs \"90 deg\", or " +
               study.key(&Support::supports) + " = \"clamped\"");
}

void check_pulses(const Configuration& study, const Complain& complain) {
  for (const auto list : {&Pulses::durations, &Pulses::angular_frequencies})
    check_distinct(study.key(list), study.value(list), study, complain);
}

void check_sensitivities(const Configuration& study, const Complain& complain) {
  if (!study.value(&VibrationOutput::sensitivities)) return;
  if (study.value(&Pulse::shape) == PulseShape::sine ||
      study.value(&Bath::model) == beam::BathModel::per_mode ||
      study.value(&Bath::drag_coefficient) > 0)
    complain(study.key(&VibrationOutput::sensitivities),
             "takes a pulse (no sine), bath.model \"none\", \"frequency\" or \"constant\", and no "
             "quadratic drag; set it to false, or change these");
}

}  // namespace

void declare_supports(Schema& schema, const std::string& section) {
  TableKeys<Support> keys(schema, section);
  keys.choice("supports", &Support::supports, kSupports)
      .doc(
          "Clamped at the moving support and free at the tip, which is observed (Figure 5.24); or "
          "simply supported at both ends, the left one moving, observed at the centre (Figure "
          "5.25).");
  schema.check(check_direction);
}

void declare_pulses(Schema& schema) {
  TableKeys<Pulses> keys(schema, "pulse");
  keys.quantities("durations", &Pulses::durations, "s",
                  {"60 us", "120 us", "180 us", "240 us", "300 us", "360 us", "420 us", "480 us",
                   "540 us", "600 us"})
      .in("(0, 1]")
      .doc("Durations of a triangular pulse, one run each (5.5: 60 to 600 us in steps of 60 us).");
  keys.quantities("angular_frequencies", &Pulses::angular_frequencies, "rad/s",
                  {"5200 rad/s", "52000 rad/s", "208000 rad/s"})
      .in("(0, 1e9]")
      .doc("Angular frequencies of a sine, one run each (Figure 5.26).");
  schema.check(check_pulses);
}

void declare_vibration_output(Schema& schema) {
  TableKeys<VibrationOutput> keys(schema, "output", "What is written into the run directory.");
  keys.boolean("history", &VibrationOutput::history, true)
      .doc(
          "Whether the tip's motion of every run is kept, in history.csv. Sweeps of thousands of "
          "runs need only amplitudes.csv, which is always written.");

  keys.boolean("sensitivities", &VibrationOutput::sensitivities, false)
      .doc(
          "Whether the derivatives of each run's amplitude, peak velocity and ring-down by every "
          "input are computed, into sensitivities.csv and summary.json. Exact (forward sensitivity "
          "analysis), for pulses without a quadratic drag.");
  schema.check(check_sensitivities);
}

}  // namespace zona::studies
