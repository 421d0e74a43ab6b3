#pragma once

#include <string>

#include "studies/input/configuration.h"
#include "studies/input/schema.h"

namespace zona::studies {

/// Fluids that fill a pipette, by name, with their densities [kg/m^3] (beam::named_fluids).
std::vector<NamedValue> fill_fluids();

/// Keys that several study kinds share, with the same meaning. Each call declares some keys of the
/// section that is open.
void declare_pipette_bore(Schema& schema, const std::string& section);
void declare_beam(Schema& schema, const std::string& section, long elements);
void declare_fill_fluids(Schema& schema);
/// Where in the bore the fluid of [fill] stands, and the list of [[column]]s of other fluids.
void declare_fill_place(Schema& schema);
void declare_columns(Schema& schema);
/// The section [bath]: the liquid that a beam dips into.
void declare_bath(Schema& schema);
void declare_pulse_form(Schema& schema, const std::vector<std::string>& shapes);
/// The first of the integrators is the default.
void declare_beam_integration(Schema& schema, const std::string& section,
                              const std::vector<std::string>& integrators);

/// Keys of the section [run] that any study may have.
void declare_threads_and_log(Schema& schema);
/// The section [run] of studies that take many steps.
void declare_run(Schema& schema);

/// Complains unless the bore `section`.inner_diameter is narrower than the pipette.
void check_bore(const std::string& section, const Configuration& study, const Complain& complain);

/// Complains about a beam's taper, columns and bath where they contradict each other or its
/// integrator, which stands in the section `time`.
void check_beam_details(const std::string& section, const std::string& time,
                        const Configuration& study, const Complain& complain);

/// Parts of the support's motion across the pipette and along it: sine and cosine of pulse.angle,
/// 1 and 0, exactly, at a right angle.
struct PulseDirection {
  double across = 1;  ///< sine
  double along = 0;   ///< cosine
};
PulseDirection pulse_direction(const Configuration& study);

/// Complains about a pulse whose shape lacks something.
void check_pulse(const Configuration& study, const Complain& complain);

/// Complains about values that a list has twice; each makes a run with a name of its own.
void check_distinct(const std::string& key, const Configuration& study, const Complain& complain);

/// Complains unless `step_key` goes into `end_key` at least once and at most 1e8 times.
void check_steps(const std::string& step_key, const std::string& end_key,
                 const Configuration& study, const Complain& complain);

}  // namespace zona::studies
