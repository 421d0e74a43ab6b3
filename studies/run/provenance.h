#pragma once

#include <string>

namespace zona::studies {

/// The git commit of the program's sources, twelve digits; "unknown" where they were no checkout.
std::string commit();
/// Whether the sources had changes that were not committed.
bool is_modified();

/// The processor that the program runs on, e.g. "AMD EPYC 7763 64-Core Processor"; "unknown" where
/// the system does not say.
std::string processor_name();

/// Version, commit, compiler, instruction set and processor, in one line.
std::string provenance();

}  // namespace zona::studies
