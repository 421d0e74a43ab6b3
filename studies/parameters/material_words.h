#pragma once

#include "studies/input/binding.h"

namespace zona::studies {

/// Materials of a body.
enum class MaterialName { solid, gas, liquid, membrane, rigid };

inline const Words<MaterialName> kMaterialNames{{"solid", MaterialName::solid},
                                                {"gas", MaterialName::gas},
                                                {"liquid", MaterialName::liquid},
                                                {"membrane", MaterialName::membrane},
                                                {"rigid", MaterialName::rigid}};

/// The law of a solid or membrane.
enum class LawName { elastic, elastodamage, von_mises, decohesion };

inline const Words<LawName> kLawNames{{"elastic", LawName::elastic},
                                      {"elastodamage", LawName::elastodamage},
                                      {"von_mises", LawName::von_mises},
                                      {"decohesion", LawName::decohesion}};

}  // namespace zona::studies
