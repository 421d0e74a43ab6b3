#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "studies/run/file_lock.h"

namespace spdlog {
class logger;
}

namespace zona::studies {

/// The directory of one run and its log. While the object lives, the directory exists, is writable
/// and is locked against other processes.
class RunDirectory {
 public:
  /// A directory that the user named. Throws InputError when it holds something or cannot be
  /// written.
  static RunDirectory named(const std::filesystem::path& directory);

  /// runs/<stem of the study file> in the working directory, or the first of ...-2, ...-3 that is
  /// free. Throws InputError when it cannot be written.
  static RunDirectory for_study(const std::filesystem::path& study_file);

  /// The directory of a run that is resumed. Throws InputError when there is no run in it, it
  /// cannot be written or another process computes in it.
  static RunDirectory of_run(const std::filesystem::path& directory);

  /// The last directory that `for_study` has made; the first name if it has made none.
  static std::filesystem::path last_for_study(const std::filesystem::path& study_file);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path file(const std::string& name) const { return path_ / name; }

  /// Writes a whole file so that readers see the old or the new one, never a part. Throws RunError.
  void write(const std::string& name, const std::string& text) const;

  /// Writes lines with time and level to log.txt: `log().info("{} points", n)`. Threads may write
  /// side by side.
  spdlog::logger& log() const { return *log_; }
  /// A log to the same file whose lines begin with "part: ", e.g. of a fill of a comparison.
  std::shared_ptr<spdlog::logger> log_of(const std::string& part) const;

 private:
  explicit RunDirectory(std::filesystem::path path);

  std::filesystem::path path_;
  std::shared_ptr<spdlog::logger> log_;
  FileLock lock_;  ///< on the log
};

/// Local date and time, "2026-01-31 12:34:56".
std::string local_time();

}  // namespace zona::studies
