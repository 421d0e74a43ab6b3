#pragma once

#include <functional>
#include <string>

#include "mpm/membranes/membrane.h"
#include "studies/input/configuration.h"
#include "studies/input/schema.h"

namespace zona::studies {

/// Added to every key of a group that is declared, e.g. a condition; nothing by default.
using EachKey = std::function<void(Parameter&)>;

/// Defaults of a von Mises model, in the user's notation.
struct PlasticityDefaults {
  std::string yield_strength;
  std::string peak_strength;  ///< or "auto": no hardening
  std::string hardening_modulus;
  std::string softening_modulus;
};

/// Of the zona pellucida (5.4), and of a solid that flows at a constant strength.
PlasticityDefaults zona_plasticity();
PlasticityDefaults perfect_plasticity();

/// Keys c0, c1 and elastic_limit below `prefix`, e.g. "zona.".
void declare_elastodamage(Schema& schema, const std::string& prefix, const EachKey& each = {});

/// Keys yield_strength, peak_strength, hardening_modulus and softening_modulus.
void declare_von_mises(Schema& schema, const std::string& prefix,
                       const PlasticityDefaults& defaults, const EachKey& each = {});

/// Keys reference_opening, decohesion_exponent, mode_ratio and reference_traction.
void declare_decohesion(Schema& schema, const std::string& prefix, const EachKey& each = {});

/// Key bifurcation, of membranes.
void declare_localization(Schema& schema, const std::string& prefix, const EachKey& each = {});

/// Keys one_way and stress_update, of membranes.
void declare_one_way(Schema& schema, const std::string& prefix, const EachKey& each = {});
void declare_stress_update(Schema& schema, const std::string& prefix, const EachKey& each = {});

/// Complains unless the strengths and moduli below `prefix` go together.
void check_von_mises(const std::string& prefix, const Configuration& study,
                     const Complain& complain);

mpm::OneWay one_way_of(const std::string& name);
mpm::Localization localization_of(const std::string& name);

// What the keys say. `Values` is asked by `prefix` and the key's last part: a Configuration, or
// whatever else has quantity(), number() and is_auto().

template <class Values>
mpm::Elastodamage elastodamage_from(const Values& values, const std::string& prefix) {
  return {values.number(prefix + "c0"), values.number(prefix + "c1"),
          values.number(prefix + "elastic_limit")};
}

template <class Values>
mpm::VonMises von_mises_from(const Values& values, const std::string& prefix) {
  const double yield = values.quantity(prefix + "yield_strength");
  const std::string peak = prefix + "peak_strength";
  return {yield,
          values.is_auto(peak) ? yield : values.quantity(peak),
          values.quantity(prefix + "hardening_modulus"),
          values.quantity(prefix + "softening_modulus"),
          {}};
}

/// `cell` are the edges of the grid's cells [m].
template <class Values>
mpm::Decohesion decohesion_from(const Values& values, const std::string& prefix,
                                const Eigen::Vector3d& cell) {
  mpm::Decohesion law;
  law.reference_opening = values.quantity(prefix + "reference_opening");
  law.exponent = values.number(prefix + "decohesion_exponent");
  law.mode_ratio = values.number(prefix + "mode_ratio");
  const std::string traction = prefix + "reference_traction";
  law.reference_traction = values.is_auto(traction) ? 0 : values.quantity(traction);
  law.cell = cell;
  return law;
}

}  // namespace zona::studies
