#include "mpm/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace zona::mpm {

namespace {

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool write_to_disk(const std::string& path, std::string_view text) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return false;
  const bool written = write_all(file, text) && fsync(file) == 0;
  const int reason = errno;
  const bool closed = close(file) == 0;
  if (!written) errno = reason;
  return written && closed;
}

/// Syncs the names in the directory of `path`. File systems that cannot do so are no failure.
void sync_directory_of(const std::string& path) {
  const auto directory = std::filesystem::absolute(path).parent_path();
  const int file = open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  fsync(file);
  close(file);
}

}  // namespace

void replace_file(const std::string& path, std::string_view text) {
  const std::string unfinished = path + ".tmp";
  if (write_to_disk(unfinished, text) && std::rename(unfinished.c_str(), path.c_str()) == 0) {
    return sync_directory_of(path);
  }
  const std::string reason = std::strerror(errno);
  std::remove(unfinished.c_str());
  throw FileError(fmt::format("{}: cannot be written ({})", path, reason));
}

void sync_to_disk(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && fsync(file) == 0;
  const std::string reason = std::strerror(errno);
  if (file >= 0) close(file);
  if (!done) throw FileError(fmt::format("{}: cannot be synced to the disk ({})", path, reason));
}

}  // namespace zona::mpm
