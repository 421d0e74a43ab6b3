#pragma once

#include "studies/verification/verification_case.h"

namespace zona::studies::verification {

Case pipette_frequencies();
Case pipette_amplitude();
Case support_motion();

}  // namespace zona::studies::verification
