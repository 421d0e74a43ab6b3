#pragma once

#include "mpm/step/solver.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// Adds what acts on the bodies of a scene to its model: [[hold]], [[load]], and the motions of
/// rigid bodies, all functions of time. Formulas are tried over the whole run. Throws InputError,
/// naming key and line.
void add_holds(const Configuration& study, mpm::Model& model);
void add_loads(const Configuration& study, mpm::Model& model);

/// `step` [s] is the solver's: velocities are slopes of the displacement over a part of it.
void set_rigid_motions(const Configuration& study, double step, mpm::Model& model);

}  // namespace zona::studies
