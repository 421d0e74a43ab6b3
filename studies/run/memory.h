#pragma once

namespace zona::studies {

/// Most memory that this process has had so far [bytes].
long peak_memory();

/// Memory still available on this machine [bytes]; infinite where the system does not say.
double available_memory();

/// Memory that this process has allocated at present [bytes].
double allocated_memory();

}  // namespace zona::studies
