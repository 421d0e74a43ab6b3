#pragma once

#include <filesystem>

namespace zona::studies {

/// A lock on an existing file, by which processes tell one another that they work on something. It
/// is gone when the object or the process is, however that ends.
class FileLock {
 public:
  /// Takes the lock if nobody has it. File systems that know no locks give it to everybody.
  explicit FileLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;

  bool is_held() const { return is_held_; }

 private:
  int file_ = -1;
  bool is_held_ = false;
};

}  // namespace zona::studies
