#pragma once

#include <optional>
#include <string>

namespace zona::mpm {

/// All bytes of the file at `path`; nothing when it cannot be opened or read.
std::optional<std::string> read_file(const std::string& path);

}  // namespace zona::mpm
