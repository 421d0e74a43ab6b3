#include "studies/kinds/piercing/motion_table.h"

#include <fmt/format.h>

namespace zona::studies {

namespace {

const Words<MotionKind> kKinds{{"sine", MotionKind::sine},
                               {"triangle", MotionKind::triangle},
                               {"beam", MotionKind::beam},
                               {"trace", MotionKind::trace}};
const Words<MotionAxis> kAxes{{"lateral", MotionAxis::lateral}, {"axial", MotionAxis::axial}};

void declare_window(TableKeys<MotionWindow> keys, const std::string& scaled) {
  keys.number("scale", &MotionWindow::scale, 1)
      .in("[-1e6, 1e6]")
      .doc("Factor on the displacement of " + scaled + ".");
  keys.quantity("ramp", &MotionWindow::ramp, "s", "0 s")
      .in("[0, 1]")
      .doc(
          "Time over which the motion fades in smoothly; none in the source, whose sine starts "
          "with 0.85 m/s at once.");
  keys.quantity("window_start", &MotionWindow::window_start, "s", "auto")
      .in("[0, 10]")
      .or_auto()
      .doc(
          "Time of the beam's or the trace's history at which the piercing starts; \"auto\" when "
          "the tip first moves by auto_fraction of its peak.");
  keys.quantity("window_length", &MotionWindow::window_length, "s", "300 us")
      .in("(0, 10]")
      .doc(
          "Length of the history that is used. The tip responds about 100 us after a 60 us pulse "
          "and then swings with half-periods of 50 to 100 us.");
  keys.number("auto_fraction", &MotionWindow::auto_fraction, 0.01)
      .in("(0, 1)")
      .doc("Fraction of the tip's peak displacement that starts an \"auto\" window.");
}

void check_trace(const Configuration& study, const Complain& complain) {
  if (study.value(&Motion::kind) != MotionKind::trace || !study.value(&Motion::trace).empty())
    return;
  const std::string key = study.key(&Motion::trace);
  complain(key, fmt::format("is missing; {} = \"trace\" needs the path of a CSV file; write e.g. "
                            "{} = \"trace.csv\"",
                            study.key(&Motion::kind), key));
}

void check_axis(const Configuration& study, const Complain& complain) {
  if (study.value(&Motion::kind) != MotionKind::beam ||
      study.value(&Motion::axis) == MotionAxis::lateral)
    return;
  complain(study.key(&Motion::axis),
           "a beam's tip moves as its support does, whose direction is pulse.angle; leave "
           "motion.axis out, and write pulse.angle = \"0 deg\" for a motion along the pipette");
}

}  // namespace

void declare_motion(Schema& schema) {
  TableKeys<Motion> keys(schema, "motion", "Motion of the tip of the injection pipette.");
  keys.choice("kind", &Motion::kind, kKinds)
      .doc(
          "A sine (5.4, lateral), a triangular pulse (5.4, axial), the tip of the beam in [beam] "
          "after the pulse in [pulse], or a recorded history.");
  keys.choice("axis", &Motion::axis, kAxes)
      .doc(
          "Across the pipette, or along it towards the oocyte. A beam takes its direction from "
          "pulse.angle instead.");
  keys.quantity("amplitude", &Motion::amplitude, "m", "auto")
      .in("[-1e-3, 1e-3]")
      .or_auto()
      .doc(
          "Amplitude of the sine or peak of the triangle; \"auto\" is 13.5 um for a sine and 1.8 "
          "um for a triangle (5.4).");
  keys.quantity("period", &Motion::period, "s", "100 us")
      .in("(0, 1]")
      .doc("Period of the sine (5.4).");
  keys.quantity("duration", &Motion::duration, "s", "60 us")
      .in("(0, 1]")
      .doc("Duration of the triangle (5.4).");
  keys.file("trace", &Motion::trace, "")
      .doc(
          "File of the recorded history, CSV or HDF5. The CSV begins with headings that carry "
          "units, such as `time [us],displacement [um]`. Needed by motion.kind = \"trace\".");
  declare_window({schema, keys.section()}, "a beam or a trace");
  schema.check(check_trace);
  schema.check(check_axis);
}

void declare_beam_motion(Schema& schema) {
  TableKeys<Motion> keys(schema, "motion",
                         "Motion of the tip of the injection pipette: always that of its beam.");
  keys.choice("kind", &Motion::kind, {{"beam", MotionKind::beam}})
      .doc("The tip of the beam in [beam].");
  keys.choice("axis", &Motion::axis, {{"lateral", MotionAxis::lateral}})
      .doc("Has no effect: a beam takes its direction from pulse.angle.");
  declare_window({schema, keys.section()}, "the beam's tip");
}

double Motion::peak() const {
  if (amplitude) return *amplitude;
  return kind == MotionKind::triangle ? 1.8e-6 : 13.5e-6;
}

Eigen::Vector3d Motion::direction() const {
  return axis == MotionAxis::axial ? kAxial : kLateral;
}

coupling::TipMotionOptions window_options(const MotionWindow& window, double length,
                                          const Eigen::Vector3d& axis) {
  coupling::TipMotionOptions options;
  if (window.window_start) options.start = *window.window_start;
  options.start_fraction = window.auto_fraction;
  options.length = length;
  options.scale = window.scale;
  options.axis = axis;
  options.ramp = window.ramp;
  return options;
}

std::string window_key(const Configuration& study) {
  return study.value(&MotionWindow::window_start) ? study.key(&MotionWindow::window_start)
                                                  : study.key(&MotionWindow::window_length);
}

}  // namespace zona::studies
