#include "studies/run/history_file.h"

#include <fmt/format.h>

#include <stdexcept>

#include "mpm/files/atomic_file.h"
#include "studies/input/input_error.h"

namespace zona::studies {

HistoryFile::HistoryFile(const std::filesystem::path& file, const std::vector<Column>& columns,
                         bool is_resumed)
    : file_(file),
      stream_(file, is_resumed ? std::ios::app : std::ios::out),
      width_(columns.size()),
      flushed_(std::chrono::steady_clock::now()) {
  std::string header;
  for (const Column& column : columns) {
    if (!header.empty()) header += ',';
    header += column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
  }
  if (!is_resumed) stream_ << header << std::endl;
  if (!stream_) throw RunError(file_.string() + " cannot be written");
}

void HistoryFile::visit_state(mpm::StateVisitor& visitor) {
  stream_.flush();
  std::error_code failure;
  std::int64_t size = static_cast<std::int64_t>(std::filesystem::file_size(file_, failure));
  const std::int64_t present = size;
  visitor.visit("files/" + file_.filename().string(), size);
  if (!stream_ || failure) throw RunError(file_.string() + " cannot be written; is the disk full?");
  if (!visitor.is_restoring()) return mpm::sync_to_disk(file_.string());
  if (present < size) {
    throw RunError(
        fmt::format("{} has lost rows: it has {} bytes, but had {} when the checkpoint "
                    "was made",
                    file_.string(), present, size));
  }
  std::filesystem::resize_file(file_, static_cast<std::uintmax_t>(size));
}

void HistoryFile::add(const std::vector<double>& row) {
  write("", row, width_);
}

void HistoryFile::add(const std::string& word, const std::vector<double>& row) {
  write(word, row, width_ - 1);
}

void HistoryFile::write(std::string line, const std::vector<double>& row, std::size_t values) {
  if (row.size() != values) {
    throw std::logic_error(
        fmt::format("a row of {} has {} values instead of {}", file_.string(), row.size(), values));
  }
  for (const double value : row) line += fmt::format("{}{}", line.empty() ? "" : ",", value);
  stream_ << line << '\n';
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ > std::chrono::seconds(1)) {
    stream_.flush();
    flushed_ = now;
  }
  if (!stream_) throw RunError(file_.string() + " cannot be written; is the disk full?");
}

}  // namespace zona::studies
