#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beam/pipette/fluid.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// Fluids that fill a pipette, by name, with their densities [kg/m^3] (beam::named_fluids).
std::vector<NamedValue> fill_fluids();

/// The fluid of a study with one.
struct Fill {
  NamedQuantity fluid;  ///< density [kg/m^3]
};

/// The fluids of a study with a run for each.
struct Fills {
  std::vector<NamedQuantity> fluids;  ///< densities [kg/m^3]
};

/// Place of the fluid of [fill] in the bore.
struct FillPlace {
  std::optional<double> viscosity;  ///< [Pa s]; empty: the named fluid's, else water's
  double start;                     ///< from the tip [m]
  std::optional<double> end;        ///< from the tip [m]; empty: at the support
};

/// A part of the bore that another fluid fills.
struct FluidColumn {
  NamedQuantity fluid;              ///< density [kg/m^3]
  std::optional<double> viscosity;  ///< as of FillPlace
  double start;
  std::optional<double> end;
};

/// Keys of [fill], which must be open.
void declare_fill(Schema& schema);
void declare_fills(Schema& schema);
/// Keys of [fill], which must be open; Beam is declared before the study is checked.
void declare_fill_place(Schema& schema);
/// The list [[column]].
void declare_columns(Schema& schema);

/// The fluid or fluids of [fill], named as in the study, by density if they have no name. The
/// viscosity of each is fill.viscosity, else its own, else that of water.
std::vector<beam::Fluid> fills_of(const Configuration& study);

/// The viscosity [Pa s] of a fluid by this name: the given one, else its own, else that of water.
double viscosity_of(const std::optional<double>& given, const std::string& fluid);

/// Complains of values that a list has twice, because each names a run.
void check_distinct(const std::string& key, const std::vector<double>& values,
                    const Configuration& study, const Complain& complain);

}  // namespace zona::studies
