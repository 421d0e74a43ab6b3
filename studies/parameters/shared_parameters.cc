#include "studies/parameters/shared_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beam/pipette/fluid.h"

namespace zona::studies {

std::vector<NamedValue> fill_fluids() {
  std::vector<NamedValue> fluids;
  for (const beam::Fluid& fluid : beam::named_fluids())
    fluids.emplace_back(fluid.name, fluid.density);
  return fluids;
}

void declare_pipette_bore(Schema& schema, const std::string& section) {
  schema.quantity(section + ".outer_diameter", "m", "10 um")
      .in("(0, 0.01]")
      .doc(
          "Outer diameter of the injection pipette (5.4; with the bore it gives EI of Table 5.5).");
  schema.quantity(section + ".inner_diameter", "m", "8 um")
      .in("[0, 0.01]")
      .doc("Diameter of the bore, which the fluid fills; zero for a solid rod (5.4).");
}

void declare_beam(Schema& schema, const std::string& section, long elements) {
  schema.quantity(section + ".length", "m", "10 mm")
      .in("(0, 1]")
      .called("L")
      .doc(
          "Free length between support and tip. The source does not give it; Tables 5.5 and 5.6 "
          "fix it.");
  schema.quantity(section + ".youngs_modulus", "Pa", "63.44 GPa")
      .in("(0, 1e13]")
      .called("E")
      .doc("Young's modulus of the glass; gives EI = 183.86e-13 Pa m^4 of Table 5.5.");
  schema.integer(section + ".elements", elements)
      .in("[1, 1000]")
      .doc(
          "Number of cubic elements of the beam, and of the rod along it. The source's twenty "
          "(5.5) overestimate the "
          "amplitude "
          "of the mercury-filled tip after 60 us by a third; eighty are good to 1 % of the peak.");
  schema.quantity(section + ".rayleigh_alpha", "1/s", "0 1/s")
      .in("[0, 1e9]")
      .doc("Mass-proportional Rayleigh damping; the source has none.");
  schema.quantity(section + ".rayleigh_beta", "s", "0 s")
      .in("[0, 1]")
      .doc("Stiffness-proportional Rayleigh damping; the source has none.");
  schema.number(section + ".loss_factor", 0)
      .in("[0, 10]")
      .doc(
          "Loss factor tan(delta) of the glass, the same at all frequencies; the source has none.");
  schema.quantity(section + ".loss_frequency", "Hz", "10 kHz")
      .in("(0, 1e9]")
      .doc("Frequency at which youngs_modulus is the storage modulus of a lossy glass.");
  schema.quantity(section + ".shoulder_outer_diameter", "m", "auto")
      .in("(0, 0.01]")
      .or_auto()
      .doc(
          "Outer diameter at the support, from which the pipette tapers evenly to the tip; "
          "\"auto\" "
          "is the tip's.");
  schema.quantity(section + ".shoulder_inner_diameter", "m", "auto")
      .in("[0, 0.01]")
      .or_auto()
      .doc("Inner diameter at the support; \"auto\" keeps the ratio to the outer one of the tip.");
  schema.file(section + ".profile", "")
      .doc(
          "CSV file of diameters along the axis instead of an even taper, with the headings "
          "`distance "
          "[mm], outer [um], inner [um]` (any units of length); distances count from the tip, "
          "where "
          "the diameters must be those of [pipette].");
}

namespace {

void declare_viscosity(Schema& schema, const std::string& key) {
  schema.quantity(key, "Pa s", "auto")
      .in("(0, 1e6]")
      .or_auto()
      .doc(
          "Shear viscosity of the fluid: how well it follows the wall when the pipette moves along "
          "itself. Counts where pulse.angle is not 90 deg; across the pipette a fluid moves as the "
          "wall does. \"auto\" is that of the named fluid at 25 degrees Celsius, for one given by "
          "density that of water.");
}

}  // namespace

void declare_columns(Schema& schema) {
  schema.list(
      "column",
      "A part of the bore that another fluid than that of [fill] fills; later ones overwrite "
      "earlier ones.",
      0, false);
  schema.quantity("column.fluid", "kg/m^3", "water")
      .in("[0, 30000]")
      .or_named(fill_fluids())
      .doc("The fluid, by name or by density.");
  declare_viscosity(schema, "column.viscosity");
  schema.quantity("column.start", "m", "0 mm").in("[0, 1]").doc("Where it begins, from the tip.");
  schema.quantity("column.end", "m", "auto")
      .in("(0, 1]")
      .or_auto()
      .doc("Where it ends, from the tip; \"auto\" at the support.");
}

void declare_fill_place(Schema& schema) {
  declare_viscosity(schema, "fill.viscosity");
  schema.quantity("fill.start", "m", "0 mm")
      .in("[0, 1]")
      .doc(
          "Where in the bore the fluid begins, from the tip. In practice mercury stands far "
          "upstream: "
          "its 0.5 to 1 uL are a thousand times what the free length of such a bore holds.");
  schema.quantity("fill.end", "m", "auto")
      .in("(0, 1]")
      .or_auto()
      .doc("Where the fluid ends, from the tip; \"auto\" at the support.");
}

void declare_bath(Schema& schema) {
  schema.section("bath",
                 "The liquid that the pipette dips into, tip first, while it vibrates. The source "
                 "vibrates it in air.");
  schema.choice("bath.model", {"none", "frequency", "per_mode", "constant"})
      .doc(
          "None, as the source; the added mass and drag of a cylinder at every frequency (Sader "
          "1998); for each mode those of its own frequency (integrator \"modal\"); or those of one "
          "frequency.");
  schema.quantity("bath.density", "kg/m^3", "1000 kg/m^3")
      .in("(0, 30000]")
      .doc("Density of the liquid.");
  schema.quantity("bath.viscosity", "Pa s", "8.9e-4 Pa s")
      .in("(0, 1e3]")
      .doc("Shear viscosity of the liquid; water at 25 degrees Celsius.");
  schema.quantity("bath.immersed_length", "m", "1 mm")
      .in("[0, 1]")
      .doc("How far the pipette dips in, from the tip; its length and more is all of it.");
  schema.quantity("bath.frequency", "Hz", "10 kHz")
      .in("(0, 1e9]")
      .doc("The frequency of model = \"constant\"; the others ignore it.");
  schema.number("bath.drag_coefficient", 0)
      .in("[0, 100]")
      .called("C_D")
      .doc(
          "Coefficient of a quadratic drag on top of the linear one, rho C_D D |v| v / 2; "
          "integrators "
          "\"newmark\" and \"arkode\" only. Of order one where the tip moves by more than its "
          "diameter.");
  schema.quantity("bath.wall_distance", "m", "auto")
      .in("(0, 1]")
      .or_auto()
      .doc(
          "Distance of the pipette's axis from the nearest wall, such as the dish's floor; only "
          "warned of when it is too near. \"auto\" is far away.");
}

void declare_fill_fluids(Schema& schema) {
  schema.quantities("fill.fluids", "kg/m^3", {"none", "water", "fluorinert", "mercury"})
      .in("[0, 30000]")
      .or_named(fill_fluids())
      .doc("Fluids that fill the bore, one run each: by name (Table 5.7) or by density.");
}

void declare_pulse_form(Schema& schema, const std::vector<std::string>& shapes) {
  const bool has_sine = std::find(shapes.begin(), shapes.end(), "sine") != shapes.end();
  const std::string sine = has_sine ? ", or a sine that starts at once (Figure 5.26)" : "";
  schema.choice("pulse.shape", shapes)
      .doc(
          "Form of the support's displacement: up and down at constant speed (Figure 5.27); up, "
          "held "
          "and down; half a period of a sine; a recorded trace" +
          sine + ".");
  schema.quantity("pulse.peak", "m", "17.9 um")
      .in("(0, 0.01]")
      .or_auto()
      .doc(
          "Peak displacement of the support. Not given in the source; 17.9 um moves the tip of "
          "the mercury-filled pipette by its 13.5 um (5.4) when the beam is resolved (80 "
          "elements). \"auto\" is voltage times gain.");
  schema.quantity("pulse.angle", "rad", "90 deg")
      .in("[0, 1.5708]")
      .doc(
          "Angle between the support's motion and the pipette's axis: 90 deg is across, as the "
          "source has it, 0 deg along, towards the oocyte. Between them the tip moves as a beam "
          "after the pulse times the sine and, along itself, as a rod after the pulse times the "
          "cosine.");
  schema.quantity("pulse.voltage", "V", "10 V")
      .in("(0, 1000]")
      .doc("Setting of the controller; counts where peak = \"auto\".");
  schema.quantity("pulse.gain", "m/V", "1.79 um/V")
      .in("(0, 1e-3]")
      .doc(
          "Support displacement per voltage of the controller. The source calls this relation "
          "unknown; 1.79 um/V is its 13.5 um of the tip at 10 V.");
  schema.number("pulse.gain_uncertainty", 0.5)
      .in("[0, 1)")
      .doc(
          "Relative uncertainty of the gain: displacements scale with it, so results that scale "
          "are "
          "told with this interval where peak = \"auto\".");
  schema.number("pulse.rise_fraction", 0.25)
      .in("(0, 0.5]")
      .doc("Part of a trapezoid's duration in which it rises, and falls again.");
  schema.integer("pulse.count", 1).in("[1, 100000]").doc("Pulses in a train, not of a sine.");
  schema.quantity("pulse.repetition_rate", "Hz", "100 Hz")
      .in("(0, 1e6]")
      .doc("How often the pulses of a train begin.");
  schema.file("pulse.trace", "")
      .doc(
          "CSV file of a measured motion of the support, `time [us], displacement [um]`, from 0; "
          "needed by shape = \"trace\", which takes peaks and times from it.");
}

void declare_beam_integration(Schema& schema, const std::string& section,
                              const std::vector<std::string>& integrators) {
  schema.quantity(section + ".end", "s", "5 ms")
      .in("(0, 10]")
      .doc("Time that the beam is followed, from the start of the pulse (5.5).");
  schema.quantity(section + ".step", "s", "0.6 us")
      .in("(0, 1]")
      .called("Delta t")
      .doc("Time step of Newmark's method and spacing of the recorded history (5.5).");
  schema.choice(section + ".integrator", integrators)
      .doc(
          "Newmark with average acceleration (as the source), SUNDIALS ARKODE with error control, "
          "modal superposition, which is exact in time for pulses with straight pieces, or the "
          "inverse transform of the response to every frequency, which is exact for a bath, too. "
          "It "
          "also takes the place of modal superposition for the motion along a filled pipette, "
          "whose fluid lags differently at every frequency, unless bath.model is \"per_mode\".");
  schema.number(section + ".relative_tolerance", 1e-6)
      .in("(0, 1)")
      .doc("Relative error per step that arkode allows; the others ignore it.");
  schema.quantity(section + ".absolute_tolerance", "m", "1e-12 m")
      .in("(0, 1]")
      .doc("Absolute error of a deflection per step that arkode allows; the others ignore it.");
}

void check_bore(const std::string& section, const Configuration& study, const Complain& complain) {
  const std::string outer_key = section + ".outer_diameter",
                    inner_key = section + ".inner_diameter";
  const double outer = study.quantity(outer_key);
  const double inner = study.quantity(inner_key);
  if (inner < outer) return;
  const bool only_outer_given = study.is_default(inner_key) && !study.is_default(outer_key);
  complain(only_outer_given ? outer_key : inner_key,
           fmt::format("the bore of {:g} um is not narrower than the pipette of {:g} um; make {} "
                       "smaller than {}",
                       inner * 1e6, outer * 1e6, inner_key, outer_key));
}

void declare_threads_and_log(Schema& schema) {
  schema.integer("run.threads", 0).in("[0, 4096]").doc("Number of threads; 0 takes all.");
  schema.choice("run.log_level", {"info", "debug", "warning", "error"})
      .doc(
          "What log.txt holds: \"debug\" adds every frame; \"warning\" and \"error\" leave out "
          "what "
          "went well.");
}

void declare_run(Schema& schema) {
  schema.section("run", "How the program runs. The results do not depend on it.");
  declare_threads_and_log(schema);
  schema.quantity("run.checkpoint_interval", "s", "300 s")
      .in("[0, 1e7]")
      .doc(
          "Wall time between two checkpoints, from which --resume goes on; with 0 they are left to "
          "checkpoint_steps. The latest two are kept until the run is complete.");
  schema.integer("run.checkpoint_steps", 0)
      .in("[0, 1000000000]")
      .doc("Steps between two checkpoints, next to those by time; 0 makes none.");
}

void check_beam_details(const std::string& section, const std::string& time,
                        const Configuration& study, const Complain& complain) {
  const double length = study.quantity(section + ".length");
  const auto check_span = [&](const std::string& start_key, const std::string& end_key) {
    const double start = study.quantity(start_key);
    const double end = study.is_auto(end_key) ? length : study.quantity(end_key);
    if (start < end) return;
    complain(study.is_auto(end_key) ? start_key : end_key,
             fmt::format("the fluid begins {:g} mm from the tip and ends at {:g} mm; it must end "
                         "beyond its beginning, and the pipette is {:g} mm long",
                         start * 1e3, end * 1e3, length * 1e3));
  };
  check_span("fill.start", "fill.end");
  for (std::size_t i = 0; i < study.item_count("column"); ++i)
    check_span(fmt::format("column.{}.start", i), fmt::format("column.{}.end", i));
  const std::string outer = section + ".shoulder_outer_diameter";
  const std::string inner = section + ".shoulder_inner_diameter";
  if (!study.path(section + ".profile").empty()) {
    for (const std::string& key : {outer, inner})
      if (!study.is_auto(key))
        complain(key, fmt::format("is given beside {}.profile, which says the diameters already; "
                                  "remove one of them",
                                  section));
  }
  const std::string& model = study.choice("bath.model");
  const std::string& integrator = study.choice(time + ".integrator");
  if (model == "none") return;
  const bool has_drag = study.number("bath.drag_coefficient") > 0;
  if (model == "per_mode" && integrator != "modal")
    complain("bath.model", fmt::format("per_mode is for {}.integrator = \"modal\"; choose that, or "
                                       "model = \"frequency\"",
                                       time));
  if (model != "per_mode" && integrator == "modal")
    complain(
        time + ".integrator",
        fmt::format("modal superposition takes bath.model = \"per_mode\" only; choose that, or "
                    "integrator \"transform\" or \"newmark\" for \"{}\"",
                    model));
  if (has_drag && (integrator == "modal" || integrator == "transform"))
    complain("bath.drag_coefficient",
             "a quadratic drag is not linear; it needs the integrator \"newmark\" or \"arkode\"");
}

PulseDirection pulse_direction(const Configuration& study) {
  const double angle = study.quantity("pulse.angle");
  constexpr double rounding = 1e-12;  // of a right angle in radians
  if (std::abs(std::cos(angle)) < rounding) return {1, 0};
  return {std::sin(angle), std::cos(angle)};
}

void check_pulse(const Configuration& study, const Complain& complain) {
  if (study.choice("pulse.shape") == "trace" && study.path("pulse.trace").empty())
    complain("pulse.trace",
             "is missing; pulse.shape = \"trace\" needs the path of a CSV file; write e.g. "
             "pulse.trace = \"support.csv\"");
  if (study.choice("pulse.shape") == "sine" && study.integer("pulse.count") > 1)
    complain("pulse.count", "a sine goes on without end; trains are made of the other shapes");
}

void check_distinct(const std::string& key, const Configuration& study, const Complain& complain) {
  const std::vector<double> values = study.quantities(key);
  for (std::size_t i = 1; i < values.size(); ++i) {
    const auto here = values.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(values.begin(), here, values[i]) == here) continue;
    complain(key, fmt::format("\"{}\" stands in the list twice; list each value once",
                              printable(study.texts(key)[i])));
  }
}

void check_steps(const std::string& step_key, const std::string& end_key,
                 const Configuration& study, const Complain& complain) {
  const double step = study.quantity(step_key);
  const double end = study.quantity(end_key);
  if (step > end) {
    complain(step_key, fmt::format("the step of {:g} us is longer than the run of {:g} us; choose "
                                   "one below {}",
                                   step * 1e6, end * 1e6, end_key));
  } else if (end / step > 1e8) {
    complain(step_key, fmt::format("the step of {:g} us makes {:g} steps of the run of {:g} us; at "
                                   "most 1e8 are allowed, so choose at least {:g} us",
                                   step * 1e6, end / step, end * 1e6, end * 1e6 / 1e8));
  }
}

}  // namespace zona::studies
