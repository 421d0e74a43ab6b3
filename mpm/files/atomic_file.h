#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace zona::mpm {

/// A file could not be written; `what()` names it and gives the system's reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Replaces the content of the file at `path` by `text`, atomically: a reader finds the old or the
/// new content, never a part, even after a crash of the machine. Writes `path`.tmp, syncs it to the
/// disk and renames it. Throws `FileError` and then leaves the old content in place.
void replace_file(const std::string& path, std::string_view text);

/// Waits until everything written to a file is on the disk. Throws `FileError`.
void sync_to_disk(const std::string& path);

}  // namespace zona::mpm
