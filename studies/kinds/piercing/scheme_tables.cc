#include "studies/kinds/piercing/scheme_tables.h"

#include <fmt/format.h>

#include "studies/kinds/piercing/motion_table.h"
#include "studies/parameters/face_conditions.h"
#include "studies/parameters/numerics_table.h"
#include "studies/parameters/output_table.h"
#include "studies/parameters/run_table.h"
#include "studies/parameters/step_table.h"

namespace zona::studies {

namespace {

void check_ramp(const Configuration& study, const Complain& complain) {
  const double ramp = study.value(&MotionWindow::ramp);
  const double end = simulation_end(study);
  if (ramp <= end) return;
  complain(study.key(&MotionWindow::ramp),
           fmt::format("{:g} us are longer than the simulation of {:g} us; choose a shorter ramp",
                       ramp * 1e6, end * 1e6));
}

void check_step(const Configuration& study, const Complain& complain) {
  const auto step = study.value(&StepChoice::step);
  if (!step) return;
  const double end = simulation_end(study);
  if (*step <= end && end / *step <= 1e9) return;
  complain(
      study.key(&StepChoice::step),
      fmt::format("{:g} ns do not fit a simulation of {:g} us; needs at most its length and at "
                  "most 1e9 steps, or \"auto\"",
                  *step * 1e9, end * 1e6));
}

}  // namespace

void declare_scheme(Schema& schema) {
  TableKeys<Scheme> keys(schema, "numerics",
                         "Choices of the scheme; the defaults are the source's.");
  keys.choice("interpolation", &Scheme::interpolation, interpolations()).doc(kInterpolationText);
  keys.boolean("average_volume_strain", &Scheme::average_volume_strain, false)
      .doc(kAverageVolumeText);
  keys.choice("energy_increment", &Scheme::energy_increment, energy_increments())
      .doc(kEnergyIncrementText);
  declare_numerics(schema);
}

void declare_piercing_run(Schema& schema) {
  TableKeys<PiercingTime> time(schema, "time", "Time integration of the piercing.");
  time.quantity("end", &PiercingTime::end, "s", "auto")
      .in("(0, 10]")
      .or_auto()
      .doc(
          "End of the simulation; \"auto\" is one period of a sine, the duration of a triangle, "
          "the window of a beam or a trace.");
  declare_step(schema, "(0, 1]", " (the source: 0.5 ns)");
  TableKeys<Boundary> boundary(schema, "boundary", "The faces of the domain.");
  boundary.choice("kind", &Boundary::kind, kFaceConditions, mpm::FaceCondition::absorbing)
      .doc(
          "Free, no motion through the face, no motion at all, or viscous stresses that absorb "
          "outgoing waves (5.43)-(5.50).");
  declare_output(schema, {"0.1 us", "(0, 1]", "."},
                 {"4 us", "(0, 1]", "; 4 us meets the instants of Figures 5.16-5.21."});
  declare_run(schema);
  schema.check(check_ramp);
  schema.check(check_step);
}

double simulation_end(const Configuration& study) {
  if (const auto end = study.value(&PiercingTime::end)) return *end;
  switch (study.value(&Motion::kind)) {
    case MotionKind::sine:
      return study.value(&Motion::period);
    case MotionKind::triangle:
      return study.value(&Motion::duration);
    case MotionKind::beam:
    case MotionKind::trace:
      break;
  }
  return study.value(&MotionWindow::window_length);
}

}  // namespace zona::studies
