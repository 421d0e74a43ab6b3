#pragma once

#include <functional>
#include <string>

namespace zona::studies {

/// Does `work` in a process of its own, whose memory is a copy of this one's, and forgets what
/// comes of it. Returns what ended that process early, e.g. "Segmentation fault"; nothing when the
/// work came to its end, if only by an exception. Work that takes longer than so many seconds is
/// ended.
///
/// For libraries that damaged files can make crash or hang. Throws std::system_error when there can
/// be no more processes. No other thread may be at work in what `work` uses.
std::string rehearse(const std::function<void()>& work, unsigned seconds = 60);

}  // namespace zona::studies
