#include "studies/history_file.h"

#include <fmt/format.h>

#include <stdexcept>

#include "studies/input_error.h"

namespace zona::studies {

HistoryFile::HistoryFile(const std::filesystem::path& file, const std::vector<Column>& columns)
    : file_(file),
      stream_(file),
      width_(columns.size()),
      flushed_(std::chrono::steady_clock::now()) {
  std::string header;
  for (const Column& column : columns) {
    if (!header.empty()) header += ',';
    header += column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
  }
  stream_ << header << std::endl;
  if (!stream_) throw RunError(file_.string() + " cannot be written");
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
