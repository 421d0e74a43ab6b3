#pragma once

#include <filesystem>

namespace zona::studies {

/// A lock on an existing file, which shows other processes that this one works on something. The
/// system releases it when the process ends, however that happens.
class FileLock {
 public:
  /// Takes the lock if it is free. File systems without locks give it to every process.
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
