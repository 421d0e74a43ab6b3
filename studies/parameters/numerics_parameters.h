#pragma once

#include <string>

#include "mpm/grid/background_grid.h"
#include "mpm/materials/fluid.h"
#include "mpm/step/solver.h"
#include "studies/input/configuration.h"

namespace zona::studies {

/// Choices of the scheme that every study of the material point method offers; the defaults are the
/// source's.
void declare_interpolation(Schema& schema, const std::string& key);
Parameter& declare_volume_average(Schema& schema, const std::string& key);
Parameter& declare_energy_increment(Schema& schema, const std::string& key);
/// Keys numerics.pic and numerics.damping.
void declare_pic_and_damping(Schema& schema);

mpm::Interpolation interpolation_of(const std::string& name);
mpm::EnergyIncrement energy_increment_of(const std::string& name);
mpm::Numerics numerics_from(const Configuration& study);

}  // namespace zona::studies
