#include "studies/run/run_directory.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <ctime>
#include <fstream>

#include "studies/input/input_error.h"

namespace zona::studies {

namespace fs = std::filesystem;

namespace {

void create_parents(const fs::path& directory) {
  std::error_code failure;
  const fs::path parent = fs::absolute(directory).parent_path();
  fs::create_directories(parent, failure);
  if (!failure) return;
  throw InputError(directory.string(), fmt::format("cannot be created ({}); choose another place "
                                                   "with --out DIR",
                                                   failure.message()));
}

/// True when the directory was made, false when the name is taken.
bool create_new(const fs::path& directory) {
  std::error_code failure;
  const bool created = fs::create_directory(directory, failure);
  if (!failure) return created;
  if (fs::exists(fs::symlink_status(directory))) return false;
  throw InputError(directory.string(), fmt::format("cannot be created ({}); choose another place "
                                                   "with --out DIR",
                                                   failure.message()));
}

std::shared_ptr<spdlog::logger> open_log(const fs::path& directory) {
  try {
    const auto sink =
        std::make_shared<spdlog::sinks::basic_file_sink_mt>((directory / "log.txt").string());
    auto log = std::make_shared<spdlog::logger>("", sink);
    log->set_pattern("%Y-%m-%d %H:%M:%S  %-7l  %n%v");
    log->flush_on(spdlog::level::debug);
    log->set_error_handler([](const std::string&) {});  // a full disk is noticed by what matters
    return log;
  } catch (const spdlog::spdlog_ex&) {
    throw InputError(directory.string(), "cannot be written; choose another place with --out DIR");
  }
}

}  // namespace

RunDirectory::RunDirectory(fs::path path)
    : path_(std::move(path)), log_(open_log(path_)), lock_(path_ / "log.txt") {
  if (!lock_.is_held()) {
    throw InputError(path_.string(),
                     "is being computed by another process; wait for it, or stop it");
  }
}

RunDirectory RunDirectory::of_run(const fs::path& directory) {
  if (!fs::exists(directory / "study.toml")) {
    throw InputError(directory.string(),
                     "holds no run that could go on; start it without --resume");
  }
  return RunDirectory(directory.has_filename() ? directory : directory.parent_path());
}

fs::path RunDirectory::last_for_study(const fs::path& study_file) {
  const fs::path first = fs::path("runs") / study_file.stem();
  fs::path last = first;
  for (int number = 2; number < 100000; ++number) {
    const fs::path next = fmt::format("{}-{}", first.string(), number);
    if (!fs::exists(next)) break;
    last = next;
  }
  return last;
}

RunDirectory RunDirectory::named(const fs::path& directory) {
  if (directory.empty()) throw InputError("--out", "is empty; give the path of a directory");
  // "results/" and "results" are the same directory, but only the second has a parent to create.
  const fs::path path = directory.has_filename() ? directory : directory.parent_path();
  create_parents(path);
  if (create_new(path)) return RunDirectory(path);
  std::error_code failure;
  const bool usable = fs::is_directory(path, failure) && fs::is_empty(path, failure);
  if (!usable || failure) {
    throw InputError(directory.string(),
                     "is there already and not an empty directory; delete it or choose another "
                     "name with --out DIR");
  }
  return RunDirectory(path);
}

RunDirectory RunDirectory::for_study(const fs::path& study_file) {
  const fs::path first = fs::path("runs") / study_file.stem();
  create_parents(first);
  if (create_new(first)) return RunDirectory(first);
  for (int number = 2; number < 100000; ++number) {
    const fs::path next = fmt::format("{}-{}", first.string(), number);
    if (create_new(next)) return RunDirectory(next);
  }
  throw InputError("runs", "is full of runs; delete some or choose another place with --out DIR");
}

void RunDirectory::write(const std::string& name, const std::string& text) const {
  const fs::path partial = file(name + ".partial");
  std::ofstream stream(partial, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code failure;
  if (stream) fs::rename(partial, file(name), failure);
  if (!stream || failure) {
    throw RunError(fmt::format("{} cannot be written; is the disk full?", file(name).string()));
  }
}

std::shared_ptr<spdlog::logger> RunDirectory::log_of(const std::string& part) const {
  return log_->clone(part + ": ");
}

std::string local_time() {
  return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::localtime(std::time(nullptr)));
}

}  // namespace zona::studies
