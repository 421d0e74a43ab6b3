#include "studies/parameters/material_parameters.h"

#include <fmt/format.h>

namespace zona::studies {

namespace {

/// Declares keys below a prefix.
class Group {
 public:
  Group(Schema& schema, std::string prefix, const EachKey& each)
      : schema_(schema), prefix_(std::move(prefix)), each_(each) {}

  Parameter& quantity(const char* key, const char* unit, const std::string& value) {
    return with_condition(schema_.quantity(prefix_ + key, unit, value));
  }
  Parameter& number(const char* key, double value) {
    return with_condition(schema_.number(prefix_ + key, value));
  }
  Parameter& choice(const char* key, const std::vector<std::string>& choices) {
    return with_condition(schema_.choice(prefix_ + key, choices));
  }

 private:
  Parameter& with_condition(Parameter& parameter) {
    if (each_) each_(parameter);
    return parameter;
  }

  Schema& schema_;
  std::string prefix_;
  const EachKey& each_;
};

}  // namespace

PlasticityDefaults zona_plasticity() {
  return {"1062.795 Pa", "1062.805 Pa", "17.9 Pa", "179 kPa"};
}

PlasticityDefaults perfect_plasticity() {
  return {"300 MPa", "auto", "0 Pa", "0 Pa"};
}

void declare_elastodamage(Schema& schema, const std::string& prefix, const EachKey& each) {
  Group group(schema, prefix, each);
  group.number("c0", 10)
      .in("[0, 1e6]")
      .called("c_0")
      .doc(
          "Depth of the softening (Table 5.2), in (5.10) without its factor 2, which contradicts "
          "the failure strain of 0.06.");
  group.number("c1", 10)
      .in("[0, 1e6]")
      .called("c_1")
      .doc("Speed of the softening in (5.10) (Table 5.2).");
  group.number("elastic_limit", 0.05937)
      .in("(0, 10]")
      .called("S_L")
      .doc("Greatest principal strain without damage (Table 5.2).");
}

void declare_von_mises(Schema& schema, const std::string& prefix,
                       const PlasticityDefaults& defaults, const EachKey& each) {
  Group group(schema, prefix, each);
  group.quantity("yield_strength", "Pa", defaults.yield_strength)
      .in("(0, 1e13]")
      .called("sigma_y")
      .doc("Equivalent stress at which plastic flow begins (5.13); for the zona see 5.4.");
  group.quantity("peak_strength", "Pa", defaults.peak_strength)
      .in("(0, 1e13]")
      .or_auto()
      .called("sigma_p")
      .doc("Greatest equivalent stress (5.13); \"auto\" is the yield strength, no hardening.");
  group.quantity("hardening_modulus", "Pa", defaults.hardening_modulus)
      .in("[0, 1e13]")
      .called("E_h")
      .doc("Rise of the strength with the internal variable (5.15), the norm of plastic strain.");
  group.quantity("softening_modulus", "Pa", defaults.softening_modulus)
      .in("[0, 1e13]")
      .called("E_s")
      .doc(
          "Fall of the strength behind its peak, down to zero; at sqrt(6) times the shear modulus "
          "and above nothing is left at once.");
}

void declare_decohesion(Schema& schema, const std::string& prefix, const EachKey& each) {
  Group group(schema, prefix, each);
  group.quantity("reference_opening", "m", "1e-8 m")
      .in("(0, 1]")
      .called("u_0")
      .doc("Opening at which a surface of decohesion carries nothing any more (5.36) (5.4).");
  group.number("decohesion_exponent", 1)
      .in("[1, 100]")
      .called("q")
      .doc("Form of the softening of the surface (5.36); 1 is a straight line (5.4).");
  group.number("mode_ratio", 10)
      .in("[1e-6, 1e6]")
      .called("c_m")
      .doc(
          "Shear over tensile strength of the surface: 10 opens it (mode I), 0.1 slides it (mode "
          "II), 1 does as the traction. Below (5.40) the source prints the ratio upside down.");
  group.quantity("reference_traction", "Pa", "auto")
      .in("(0, 1e13]")
      .or_auto()
      .called("tau_0")
      .doc(
          "With reference_opening it gives the energy of the surface, u_0 tau_0 q/(q + 1) per "
          "area; \"auto\" is the traction at which the surface appears. Not given in the source.");
}

void declare_localization(Schema& schema, const std::string& prefix, const EachKey& each) {
  Group(schema, prefix, each)
      .choice("bifurcation", {"plane_stress", "source"})
      .doc(
          "How the direction of decohesion is found: with the tangent of plane stress, its normal "
          "in the membrane; or by (5.28)-(5.31) for three dimensions with the third stress zero, "
          "the angle laid into the membrane.");
}

void declare_one_way(Schema& schema, const std::string& prefix, const EachKey& each) {
  Group(schema, prefix, each)
      .choice("one_way", {"stress", "strain", "off"})
      .doc(
          "How compression is cut off: taut, wrinkled or slack by the principal stresses; by the "
          "principal strains, as the source does (4.24)-(4.27); or not at all.");
}

void declare_stress_update(Schema& schema, const std::string& prefix, const EachKey& each) {
  Group(schema, prefix, each)
      .choice("stress_update", {"total", "increments"})
      .doc(
          "Of an elastic membrane: its stress from the total local strain, or as the sum of what "
          "increments of it give (5.42); one and the same curve (Figure 5.9).");
}

void check_von_mises(const std::string& prefix, const Configuration& study,
                     const Complain& complain) {
  const std::string peak_key = prefix + "peak_strength";
  if (study.is_auto(peak_key)) return;
  const double yield = study.quantity(prefix + "yield_strength");
  const double peak = study.quantity(peak_key);
  if (peak < yield) {
    complain(peak_key, fmt::format("{:g} Pa is below the yield strength of {:g} Pa; needs at least "
                                   "{}yield_strength, or \"auto\"",
                                   peak, yield, prefix));
  } else if (peak > yield && study.quantity(prefix + "hardening_modulus") == 0) {
    complain(prefix + "hardening_modulus",
             fmt::format("is zero, so that the strength never rises from {:g} Pa to its peak of "
                         "{:g} Pa; needs a value above 0 Pa, or {} = \"auto\"",
                         yield, peak, peak_key));
  }
}

mpm::OneWay one_way_of(const std::string& name) {
  if (name == "strain") return mpm::OneWay::strain;
  return name == "off" ? mpm::OneWay::off : mpm::OneWay::stress;
}

mpm::Localization localization_of(const std::string& name) {
  return name == "source" ? mpm::Localization::source : mpm::Localization::plane_stress;
}

}  // namespace zona::studies
