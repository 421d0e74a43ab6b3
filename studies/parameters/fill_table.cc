#include "studies/parameters/fill_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "beam/pipette/pipette.h"
#include "studies/parameters/beam_table.h"

namespace zona::studies {

namespace {

template <class T>
void declare_viscosity(TableKeys<T>& keys) {
  keys.quantity("viscosity", &T::viscosity, "Pa s", "auto")
      .in("(0, 1e6]")
      .or_auto()
      .doc(
          "Shear viscosity of the fluid, with which it follows the wall when the pipette moves "
          "along itself. Used where pulse.angle is not 90 deg; across the pipette a fluid moves "
          "with the wall. \"auto\" is that of the named fluid at 25 degrees Celsius, or of water "
          "for a fluid given by density.");
}

void check_span(const Configuration& study, const Complain& complain, double start,
                const std::optional<double>& given_end, const std::string& start_key,
                const std::string& end_key) {
  const double length = study.value(&Beam::length);
  const double end = given_end.value_or(length);
  if (start < end) return;
  complain(given_end ? end_key : start_key,
           fmt::format("the fluid begins {:g} mm from the tip and ends at {:g} mm; it must end "
                       "beyond its beginning, and the pipette is {:g} mm long",
                       start * 1e3, end * 1e3, length * 1e3));
}

void check_place(const Configuration& study, const Complain& complain) {
  check_span(study, complain, study.value(&FillPlace::start), study.value(&FillPlace::end),
             study.key(&FillPlace::start), study.key(&FillPlace::end));
}

void check_column(const Table& column, const Complain& complain) {
  check_span(column.study(), complain, column.value(&FluidColumn::start),
             column.value(&FluidColumn::end), column.leaf(&FluidColumn::start),
             column.leaf(&FluidColumn::end));
}

void check_fluids(const Configuration& study, const Complain& complain) {
  std::vector<double> densities;
  for (const NamedQuantity& fluid : study.value(&Fills::fluids)) densities.push_back(fluid.value);
  check_distinct(study.key(&Fills::fluids), densities, study, complain);
}

}  // namespace

std::vector<NamedValue> fill_fluids() {
  std::vector<NamedValue> fluids;
  for (const beam::Fluid& fluid : beam::named_fluids())
    fluids.emplace_back(fluid.name, fluid.density);
  return fluids;
}

void declare_fill(Schema& schema) {
  TableKeys<Fill> keys(schema, "fill");
  keys.quantity("fluid", &Fill::fluid, "kg/m^3", "mercury")
      .in("[0, 30000]")
      .or_named(fill_fluids())
      .doc("The fluid, by name (Table 5.7) or by density; adds mass to the tip and to the beam.");
}

void declare_fills(Schema& schema) {
  TableKeys<Fills> keys(schema, "fill");
  keys.quantities("fluids", &Fills::fluids, "kg/m^3", {"none", "water", "fluorinert", "mercury"})
      .in("[0, 30000]")
      .or_named(fill_fluids())
      .doc("Fluids that fill the bore, one run each: by name (Table 5.7) or by density.");
  schema.check(check_fluids);
}

void declare_fill_place(Schema& schema) {
  TableKeys<FillPlace> keys(schema, "fill");
  declare_viscosity(keys);
  keys.quantity("start", &FillPlace::start, "m", "0 mm")
      .in("[0, 1]")
      .doc(
          "Beginning of the fluid in the bore, from the tip. In practice mercury stands far "
          "upstream: its 0.5 to 1 uL are a thousand times what the free length of such a bore "
          "holds.");
  keys.quantity("end", &FillPlace::end, "m", "auto")
      .in("(0, 1]")
      .or_auto()
      .doc("End of the fluid, from the tip; \"auto\" is the support.");
  schema.check(check_place);
}

void declare_columns(Schema& schema) {
  schema.list(
      "column",
      "A part of the bore with another fluid than [fill]; later ones overwrite earlier ones.", 0,
      false);
  TableKeys<FluidColumn> keys(schema, "column");
  keys.quantity("fluid", &FluidColumn::fluid, "kg/m^3", "water")
      .in("[0, 30000]")
      .or_named(fill_fluids())
      .doc("The fluid, by name or by density.");
  declare_viscosity(keys);
  keys.quantity("start", &FluidColumn::start, "m", "0 mm")
      .in("[0, 1]")
      .doc("Its beginning, from the tip.");
  keys.quantity("end", &FluidColumn::end, "m", "auto")
      .in("(0, 1]")
      .or_auto()
      .doc("Its end, from the tip; \"auto\" is the support.");
  schema.check_each("column", check_column);
}

double viscosity_of(const std::optional<double>& given, const std::string& fluid) {
  if (given) return *given;
  for (const beam::Fluid& known : beam::named_fluids())
    if (known.name == fluid) return known.viscosity;
  return beam::Liquid{}.viscosity;
}

std::vector<beam::Fluid> fills_of(const Configuration& study) {
  const auto fluids = study.schema().binds<Fill>()
                          ? std::vector<NamedQuantity>{study.value(&Fill::fluid)}
                          : study.value(&Fills::fluids);
  const auto viscosity = study.value(&FillPlace::viscosity);
  std::vector<beam::Fluid> fills;
  for (const auto& [name, density] : fluids)
    fills.push_back({name, density, viscosity_of(viscosity, name), ""});
  return fills;
}

void check_distinct(const std::string& key, const std::vector<double>& values,
                    const Configuration& study, const Complain& complain) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    const auto here = values.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(values.begin(), here, values[i]) == here) continue;
    complain(key, fmt::format("\"{}\" stands in the list twice; list each value once",
                              printable(study.texts(key)[i])));
  }
}

}  // namespace zona::studies
