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

/// Give the file at `path` the content `text`, so that a reader at any moment, also after the
/// machine failed, finds either the old or the new content and never a part: written beside it as
/// `path`.tmp, to the disk, then renamed. Throws `FileError`; the old content is then still there.
void replace_file(const std::string& path, std::string_view text);

/// Waits until what was written to a file is on the disk. Throws `FileError`.
void bring_to_disk(const std::string& path);

}  // namespace zona::mpm
