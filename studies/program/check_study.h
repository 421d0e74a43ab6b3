#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace zona::studies {

/// `zona check`: prints every parameter in SI, what the study will cost, and what that means on
/// this machine, from trying its first steps.
int check_study(const std::filesystem::path& file, const std::vector<std::string>& overrides);

}  // namespace zona::studies
