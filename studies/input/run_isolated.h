#pragma once

#include <functional>
#include <string>

namespace zona::studies {

/// Runs `work` in a forked process and discards its results. Returns what ended that process early,
/// e.g. "Segmentation fault"; an empty text when `work` returned or threw. Ends work that takes
/// longer than `seconds`.
///
/// For libraries that damaged files can make crash or hang. Throws std::system_error when no
/// process can be started. No other thread may be using what `work` uses.
std::string run_isolated(const std::function<void()>& work, unsigned seconds = 60);

}  // namespace zona::studies
