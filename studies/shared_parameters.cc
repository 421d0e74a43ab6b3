#include "studies/shared_parameters.h"

#include <fmt/format.h>

#include <algorithm>

namespace zona::studies {

std::vector<NamedValue> fill_fluids() {
  return {{"none", 0}, {"water", 1000}, {"fluorinert", 1780}, {"mercury", 13600}};
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
          "Number of Hermite cubic beam elements. The source's twenty (5.5) overestimate the "
          "amplitude "
          "of the mercury-filled tip after 60 us by a fifth; eighty are good to 1 % of the peak.");
  schema.quantity(section + ".rayleigh_alpha", "1/s", "0 1/s")
      .in("[0, 1e9]")
      .doc("Mass-proportional Rayleigh damping; the source has none.");
  schema.quantity(section + ".rayleigh_beta", "s", "0 s")
      .in("[0, 1]")
      .doc("Stiffness-proportional Rayleigh damping; the source has none.");
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
      .doc("Form of the support's displacement: up and down at constant speed (Figure 5.27)" +
           sine + ".");
  schema.quantity("pulse.peak", "m", "17.9 um")
      .in("(0, 0.01]")
      .doc(
          "Peak displacement of the support. Not given in the source; 17.9 um moves the tip of "
          "the mercury-filled pipette by its 13.5 um (5.4) when the beam is resolved (80 "
          "elements).");
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
          "or modal superposition, which is exact in time for pulses with straight pieces.");
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

void declare_run(Schema& schema) {
  schema.section("run", "How the program runs. The results do not depend on it.");
  schema.integer("run.threads", 0).in("[0, 4096]").doc("Number of threads; 0 takes all.");
  schema.choice("run.log_level", {"info", "debug", "warning", "error"})
      .doc(
          "What log.txt holds: \"debug\" adds every frame; \"warning\" and \"error\" leave out "
          "what "
          "went well.");
  schema.quantity("run.checkpoint_interval", "s", "300 s")
      .in("[0, 1e7]")
      .doc(
          "Wall time between two checkpoints, from which --resume goes on; with 0 they are left to "
          "checkpoint_steps. The latest two are kept until the run is complete.");
  schema.integer("run.checkpoint_steps", 0)
      .in("[0, 1000000000]")
      .doc("Steps between two checkpoints, next to those by time; 0 makes none.");
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
