#pragma once

#include "studies/input/binding.h"

namespace zona::studies {

/// Which points belong to a place: those that started there, or those that are there now.
enum class Membership { initial, current };

inline const Words<Membership> kMemberships{{"initial", Membership::initial},
                                            {"current", Membership::current}};

}  // namespace zona::studies
