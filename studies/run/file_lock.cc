#include "studies/run/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace zona::studies {

FileLock::FileLock(const std::filesystem::path& file)
    : file_(open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
  is_held_ = file_ >= 0 && (flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK);
}

FileLock::FileLock(FileLock&& other) noexcept
    : file_(std::exchange(other.file_, -1)), is_held_(std::exchange(other.is_held_, false)) {}

FileLock::~FileLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace zona::studies
