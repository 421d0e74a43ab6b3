#include "studies/beam_parameters.h"

#include <stdexcept>

namespace zona::studies {

beam::Pipette pipette_from(const Configuration& study, const std::string& section,
                           double fill_density) {
  beam::Pipette pipette;
  pipette.length = study.quantity(section + ".length");
  pipette.outer_diameter = study.quantity("pipette.outer_diameter");
  pipette.inner_diameter = study.quantity("pipette.inner_diameter");
  pipette.youngs_modulus = study.quantity(section + ".youngs_modulus");
  pipette.density = study.quantity("pipette.density");
  pipette.fill_density = fill_density;
  pipette.elements = static_cast<int>(study.integer(section + ".elements"));
  pipette.damping_alpha = study.quantity(section + ".rayleigh_alpha");
  pipette.damping_beta = study.quantity(section + ".rayleigh_beta");
  try {
    beam::check(pipette);
  } catch (const std::invalid_argument& error) {
    throw InputError(std::vector<Problem>{study.problem(section + ".length", error.what())});
  }
  return pipette;
}

beam::Sampling sampling_from(const Configuration& study, const std::string& section) {
  return {study.quantity(section + ".end"), study.quantity(section + ".step")};
}

beam::Integrator integrator_from(const Configuration& study, const std::string& section,
                                 const beam::Pipette& pipette) {
  const std::string& name = study.choice(section + ".integrator");
  if (name == "modal") return beam::Modal{};
  if (name == "newmark") return beam::Newmark{};
  const auto method =
      pipette.damping_beta > 0 ? beam::RungeKutta::implicit_5 : beam::RungeKutta::explicit_8;
  return beam::Arkode{study.number(section + ".relative_tolerance"),
                      study.quantity(section + ".absolute_tolerance"), method};
}

}  // namespace zona::studies
