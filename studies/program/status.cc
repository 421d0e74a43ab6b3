#include "studies/program/status.h"

#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "studies/input/input_error.h"
#include "studies/program/exit_code.h"
#include "studies/run/file_lock.h"
#include "studies/run/progress.h"
#include "studies/simulation/checkpoints.h"

namespace zona::studies {

namespace fs = std::filesystem;

namespace {

constexpr const char* status_file = "status.json";

nlohmann::json read_json(const fs::path& file) {
  std::ifstream stream(file);
  auto json = nlohmann::json::parse(stream, nullptr, false);
  return json.is_object() ? json : nlohmann::json::object();
}

std::string progress_of(const nlohmann::json& status) {
  const auto updated = status.value("updated", std::int64_t{0});
  return fmt::format("{}\n{} ago", status.value("progress", "it has just begun"),
                     duration_text(static_cast<double>(std::time(nullptr) - updated)));
}

std::string advice(const fs::path& directory) {
  return fmt::format("go on with \"zona run {} --resume\"", directory.string());
}

}  // namespace

void leave_status(const RunDirectory& directory, const std::string& line) {
  const nlohmann::json status{{"progress", line}, {"updated", std::time(nullptr)}};
  directory.write(status_file, status.dump() + "\n");
}

void remove_status(const RunDirectory& directory) {
  std::error_code ignored;
  fs::remove(directory.file(status_file), ignored);
}

int show_status(const fs::path& directory) {
  if (!fs::exists(directory / "study.toml") || !fs::exists(directory / "log.txt"))
    throw InputError(directory.string(), "holds no run");
  const bool runs = !FileLock(directory / "log.txt").is_held();
  const bool has_status = fs::exists(directory / status_file);
  const auto status = read_json(directory / status_file);
  const auto summary = read_json(directory / "summary.json");
  if (runs) {
    std::cout << "running\n" << (has_status ? progress_of(status) : "it has just begun") << '\n';
  } else if (has_status || summary.empty()) {
    std::cout << "killed: it ended without a word\n"
              << (has_status ? progress_of(status) + "\n" : "") << advice(directory) << '\n';
  } else {
    const std::string how = summary.value("status", "unknown");
    std::cout << how;
    if (const auto message = summary.value("message", ""); !message.empty())
      std::cout << ": " << message;
    std::cout << '\n';
    if (how != "complete") std::cout << advice(directory) << '\n';
  }
  return exit_ok;
}

}  // namespace zona::studies
