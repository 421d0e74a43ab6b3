#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace zona::studies {

/// Number of single-character insertions, deletions, replacements and swaps of neighbours that
/// turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name that the user most likely meant by `wanted`, or an empty string when none is close.
/// Dotted keys also match by their last part alone, so that "cell" or "mesh.cell" finds
/// "grid.cell".
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names);

}  // namespace zona::studies
