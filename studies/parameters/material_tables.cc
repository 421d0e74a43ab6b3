#include "studies/parameters/material_tables.h"

#include <fmt/format.h>

namespace zona::studies {

namespace {

const Words<mpm::Localization> kLocalizations{{"plane_stress", mpm::Localization::plane_stress},
                                              {"source", mpm::Localization::source}};
const Words<mpm::OneWay> kOneWays{
    {"stress", mpm::OneWay::stress}, {"strain", mpm::OneWay::strain}, {"off", mpm::OneWay::off}};
const Words<StressUpdate> kStressUpdates{{"total", StressUpdate::total},
                                         {"increments", StressUpdate::increments}};
const Words<MembraneKinematics> kKinematics{{"source", MembraneKinematics::source},
                                            {"objective", MembraneKinematics::objective}};

void check_plasticity(const Table& table, const Complain& complain) {
  const std::string peak_key = table.leaf(&Plasticity::peak_strength);
  const auto peak = table.value(&Plasticity::peak_strength);
  if (!peak) return;
  const double yield = table.value(&Plasticity::yield_strength);
  if (*peak < yield) {
    complain(peak_key, fmt::format("{:g} Pa is below the yield strength of {:g} Pa; needs at least "
                                   "{}, or \"auto\"",
                                   *peak, yield, table.leaf(&Plasticity::yield_strength)));
  } else if (*peak > yield && table.value(&Plasticity::hardening_modulus) == 0) {
    complain(table.leaf(&Plasticity::hardening_modulus),
             fmt::format("is zero, so that the strength never rises from {:g} Pa to its peak of "
                         "{:g} Pa; needs a value above 0 Pa, or {} = \"auto\"",
                         yield, *peak, peak_key));
  }
}

template <class T>
TableKeys<T> keys_in(Schema& schema, const std::string& section,
                     const std::vector<Condition>& conditions) {
  TableKeys<T> keys(schema, section);
  keys.apply_only_where(conditions);
  return keys;
}

}  // namespace

Plasticity::Defaults Plasticity::zona() {
  return {"1062.795 Pa", "1062.805 Pa", "17.9 Pa", "179 kPa"};
}

Plasticity::Defaults Plasticity::perfect() {
  return {"", "auto", "0 Pa", "0 Pa"};
}

mpm::VonMises Plasticity::law() const {
  return {yield_strength,
          peak_strength.value_or(yield_strength),
          hardening_modulus,
          softening_modulus,
          {}};
}

mpm::Decohesion Separation::law(const Eigen::Vector3d& cell) const {
  mpm::Decohesion law;
  law.reference_opening = reference_opening;
  law.exponent = decohesion_exponent;
  law.mode_ratio = mode_ratio;
  law.reference_traction = reference_traction.value_or(0);
  law.cell = cell;
  return law;
}

mpm::VonMises plastic_law(const Table& table, bool with_decohesion, const Eigen::Vector3d& cell) {
  mpm::VonMises law = table.read<Plasticity>().law();
  if (!with_decohesion) return law;
  law.decohesion = table.read<Separation>().law(cell);
  law.decohesion->localization = table.read<MembraneOptions>().bifurcation;
  return law;
}

mpm::MembraneLaw MembraneOptions::elastic_law() const {
  if (stress_update == StressUpdate::increments) return mpm::IncrementalElastic{};
  return mpm::Elastic{};
}

void declare_elastodamage(Schema& schema, const std::string& section,
                          const std::vector<Condition>& conditions) {
  using mpm::Elastodamage;
  auto keys = keys_in<Elastodamage>(schema, section, conditions);
  keys.number("c0", &Elastodamage::c0, 10)
      .in("[0, 1e6]")
      .called("c_0")
      .doc(
          "Depth of the softening (Table 5.2), in (5.10) without its factor 2, which contradicts "
          "the failure strain of 0.06.");
  keys.number("c1", &Elastodamage::c1, 10)
      .in("[0, 1e6]")
      .called("c_1")
      .doc("Speed of the softening in (5.10) (Table 5.2).");
  keys.number("elastic_limit", &Elastodamage::elastic_limit, 0.05937)
      .in("(0, 10]")
      .called("S_L")
      .doc("Greatest principal strain without damage (Table 5.2).");
}

void declare_plasticity(Schema& schema, const std::string& section,
                        const Plasticity::Defaults& defaults,
                        const std::vector<Condition>& conditions) {
  auto keys = keys_in<Plasticity>(schema, section, conditions);
  Parameter& yield =
      keys.quantity("yield_strength", &Plasticity::yield_strength, "Pa", defaults.yield_strength)
          .in("(0, 1e13]")
          .called("sigma_y")
          .doc("Equivalent stress at which plastic flow begins (5.13); for the zona see 5.4.");
  if (defaults.yield_strength.empty()) yield.without_default();
  keys.quantity("peak_strength", &Plasticity::peak_strength, "Pa", defaults.peak_strength)
      .in("(0, 1e13]")
      .or_auto()
      .called("sigma_p")
      .doc("Greatest equivalent stress (5.13); \"auto\" is the yield strength, no hardening.");
  keys.quantity("hardening_modulus", &Plasticity::hardening_modulus, "Pa",
                defaults.hardening_modulus)
      .in("[0, 1e13]")
      .called("E_h")
      .doc("Rise of the strength with the internal variable (5.15), the norm of plastic strain.");
  keys.quantity("softening_modulus", &Plasticity::softening_modulus, "Pa",
                defaults.softening_modulus)
      .in("[0, 1e13]")
      .called("E_s")
      .doc(
          "Fall of the strength after its peak, down to zero; from sqrt(6) times the shear modulus "
          "on it is lost at once.");
  schema.check_table(section, check_plasticity);
}

void declare_separation(Schema& schema, const std::string& section,
                        const std::vector<Condition>& conditions) {
  auto keys = keys_in<Separation>(schema, section, conditions);
  keys.quantity("reference_opening", &Separation::reference_opening, "m", "1e-8 m")
      .in("(0, 1]")
      .called("u_0")
      .doc("Opening at which a surface of decohesion no longer carries traction (5.36) (5.4).");
  keys.number("decohesion_exponent", &Separation::decohesion_exponent, 1)
      .in("[1, 100]")
      .called("q")
      .doc("Form of the softening of the surface (5.36); 1 is a straight line (5.4).");
  keys.number("mode_ratio", &Separation::mode_ratio, 10)
      .in("[1e-6, 1e6]")
      .called("c_m")
      .doc(
          "Shear over tensile strength of the surface: 10 opens it (mode I), 0.1 slides it (mode "
          "II), 1 follows the traction. Below (5.40) the source prints the ratio upside down.");
  keys.quantity("reference_traction", &Separation::reference_traction, "Pa", "auto")
      .in("(0, 1e13]")
      .or_auto()
      .called("tau_0")
      .doc(
          "With reference_opening it gives the energy of the surface, u_0 tau_0 q/(q + 1) per "
          "area; \"auto\" is the traction at which the surface appears. Not given in the source.");
}

void declare_bifurcation(Schema& schema, const std::string& section,
                         const std::vector<Condition>& conditions) {
  keys_in<MembraneOptions>(schema, section, conditions)
      .choice("bifurcation", &MembraneOptions::bifurcation, kLocalizations)
      .doc(
          "How the direction of decohesion is found: with the tangent of plane stress, its normal "
          "in the membrane; or by (5.28)-(5.31) for three dimensions with the third stress zero, "
          "with the angle taken in the membrane.");
}

void declare_one_way(Schema& schema, const std::string& section,
                     const std::vector<Condition>& conditions) {
  keys_in<MembraneOptions>(schema, section, conditions)
      .choice("one_way", &MembraneOptions::one_way, kOneWays)
      .doc(
          "How compression is cut off: taut, wrinkled or slack by the principal stresses; by the "
          "principal strains, as the source does (4.24)-(4.27); or not at all.");
}

void declare_stress_update(Schema& schema, const std::string& section,
                           const std::vector<Condition>& conditions) {
  keys_in<MembraneOptions>(schema, section, conditions)
      .choice("stress_update", &MembraneOptions::stress_update, kStressUpdates)
      .doc(
          "Stress of an elastic membrane: from the total local strain, or summed over its "
          "increments (5.42); both give the same curve (Figure 5.9).");
}

void declare_kinematics(Schema& schema, const std::string& section,
                        const std::vector<Condition>& conditions) {
  keys_in<MembraneOptions>(schema, section, conditions)
      .choice("kinematics", &MembraneOptions::kinematics, kKinematics)
      .doc(
          "Strain of the membrane: accumulated in fixed axes and rotated (4.10), (4.21), as the "
          "source; or objective, from the deformation gradient of the triangles.");
}

}  // namespace zona::studies
