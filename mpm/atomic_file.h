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

/// Give the file at `path` the content `text`, so that a reader at any moment finds either the old
/// or the new content and never a part: written beside it, then renamed. Throws `FileError`.
void replace_file(const std::string& path, std::string_view text);

/// The second half of it: rename a finished file over `path`. Throws `FileError`.
void rename_over(const std::string& finished, const std::string& path);

}  // namespace zona::mpm
