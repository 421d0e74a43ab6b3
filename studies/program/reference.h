#pragma once

#include <string>

namespace zona::studies {

/// Every parameter of every study kind, as Markdown; docs/parameters.md is its output.
std::string parameter_reference();

/// What a name stands for: a key, a table or a study kind. Throws InputError with the nearest key
/// when it is none of them.
std::string parameter_help(const std::string& name);

/// The study kinds and their tables, in a screen.
std::string help_overview();

}  // namespace zona::studies
