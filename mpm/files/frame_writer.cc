#include "mpm/files/frame_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "mpm/files/atomic_file.h"
#include "mpm/files/xdmf.h"

namespace zona::mpm {

namespace {

[[noreturn]] void refuse(const std::string& part, const std::string& problem) {
  throw std::invalid_argument(fmt::format("frame: '{}': {}", part, problem));
}

void check_name(const std::string& cloud, const std::string& name) {
  static const char* const allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (name.empty() || name.find_first_not_of(allowed) != std::string::npos)
    refuse(cloud, fmt::format("the name '{}' must consist of letters, digits, '_', '-'", name));
}

void check_cloud(const PointCloud& cloud) {
  check_name(cloud.name, cloud.name);
  if (cloud.positions.size() % 3 != 0)
    refuse(cloud.name, fmt::format("{} coordinates are not triples", cloud.positions.size()));
  const std::size_t points = cloud.positions.size() / 3;
  for (const auto& triangle : cloud.triangles)
    for (const int corner : triangle)
      if (corner < 0 || static_cast<std::size_t>(corner) >= points)
        refuse(cloud.name, fmt::format("a triangle has corner {} of {} points", corner, points));
  for (const auto& [name, values] : cloud.fields) {
    check_name(cloud.name, name);
    if (values.size() != points && values.size() != 3 * points)
      refuse(cloud.name, fmt::format("field '{}' has {} values for {} points; give one or three "
                                     "per point",
                                     name, values.size(), points));
  }
}

std::array<std::size_t, 3> cell_counts(const CellFields& cells) {
  std::array<std::size_t, 3> counts{};
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double>& boundaries = cells.boundaries[axis];
    if (boundaries.size() < 2 || !std::is_sorted(boundaries.begin(), boundaries.end()))
      refuse(cells.name, "give two or more cell boundaries, in ascending order");
    counts[axis] = boundaries.size() - 1;
  }
  return counts;
}

void check_cells(const CellFields& cells) {
  check_name(cells.name, cells.name);
  const auto [nx, ny, nz] = cell_counts(cells);
  const std::size_t count = nx * ny * nz;
  for (const auto& [name, values] : cells.fields) {
    check_name(cells.name, name);
    if (values.size() != count && values.size() != 3 * count)
      refuse(cells.name, fmt::format("field '{}' has {} values for {} cells; give one or three per "
                                     "cell",
                                     name, values.size(), count));
  }
}

std::vector<float> rounded(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

/// Point indices of the cells of a cloud: three per triangle, or one per point.
std::vector<std::int32_t> corners_of(const PointCloud& cloud) {
  if (cloud.triangles.empty()) {
    std::vector<std::int32_t> points(cloud.positions.size() / 3);
    std::iota(points.begin(), points.end(), 0);
    return points;
  }
  std::vector<std::int32_t> corners;
  corners.reserve(3 * cloud.triangles.size());
  for (const auto& triangle : cloud.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

std::string six_digits(std::size_t frame) {
  return fmt::format("{:06}", frame);
}

std::string frame_group(std::size_t frame) {
  return "/frames/" + six_digits(frame);
}

std::string cells_group(std::size_t frame) {
  return "/cells/" + six_digits(frame);
}

}  // namespace

FrameWriter::FrameWriter(std::string directory, PositionPrecision precision,
                         std::vector<Frame> frames)
    : directory_(std::move(directory)), precision_(precision), frames_(std::move(frames)) {
  const std::filesystem::path folder = directory_ + "/fields";
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    throw FileError(fmt::format("{}: cannot be created ({})", folder.string(), failure.message()));
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string() >= six_digits(frames_.size()))
      std::filesystem::remove(entry.path());
  }
  load_topologies();
  write_index();
  write_xdmf();
}

FrameWriter::FrameWriter(const std::string& directory, PositionPrecision precision)
    : FrameWriter(directory, precision, {}) {}

FrameWriter FrameWriter::resume(const std::string& directory, double last_time,
                                PositionPrecision precision) {
  return FrameWriter(directory, precision, stored_frames(directory, last_time));
}

std::vector<FrameWriter::Frame> FrameWriter::stored_frames(const std::string& directory,
                                                           double last_time) {
  const Hdf5File file = Hdf5File::open(directory + "/fields.h5");
  std::vector<Frame> frames;
  for (const std::string& name : file.children("/frames")) {
    const double time = file.read_attribute<double>("/frames/" + name, "time");
    if (time > last_time) break;
    frames.push_back({time, {}, file.contains("/cells/" + name), xdmf_frame(file, name)});
  }
  for (const std::string& cloud : file.children("/topology")) {
    for (const std::string& name : file.children("/topology/" + cloud)) {
      const std::size_t frame = std::stoul(name);
      if (frame < frames.size())
        frames[frame].topologies.push_back("/topology/" + cloud + "/" + name);
    }
  }
  return frames;
}

void FrameWriter::load_topologies() {
  if (frames_.empty()) return;
  const Hdf5File file = Hdf5File::open(index());
  for (const Frame& frame : frames_) {
    for (const std::string& dataset : frame.topologies) {
      const std::string cloud = std::filesystem::path(dataset).parent_path().filename().string();
      topologies_[cloud] = {file.shape(dataset)[1], file.read<std::int32_t>(dataset), dataset};
    }
  }
}

void FrameWriter::check_frame(double time, const std::vector<PointCloud>& clouds,
                              const std::vector<CellFields>& cells) const {
  const double last_time =
      frames_.empty() ? -std::numeric_limits<double>::infinity() : frames_.back().time;
  if (!std::isfinite(time) || time <= last_time)
    throw std::invalid_argument(
        fmt::format("frame: time {} s must be finite and later than the previous frame at {} s",
                    time, last_time));
  std::set<std::string> names;
  for (const PointCloud& cloud : clouds) {
    check_cloud(cloud);
    if (!names.insert(cloud.name).second) refuse(cloud.name, "occurs twice");
  }
  for (const CellFields& fields : cells) {
    check_cells(fields);
    if (!names.insert(fields.name).second) refuse(fields.name, "occurs twice");
  }
}

void FrameWriter::add_frame(double time, const std::vector<PointCloud>& clouds,
                            const std::vector<CellFields>& cells) {
  check_frame(time, clouds, cells);
  const std::string group = frame_group(frames_.size());
  const std::string path = frame_file(index(), group);
  Frame frame{time, {}, !cells.empty(), ""};
  {
    Hdf5File file = Hdf5File::create_in_memory(path);
    file.create_group(group);
    for (const PointCloud& cloud : clouds)
      if (!cloud.positions.empty()) write_cloud(file, group, cloud, frame.topologies);
    std::sort(frame.topologies.begin(), frame.topologies.end());
    for (const CellFields& fields : cells) write_cells(file, cells_group(frames_.size()), fields);
    file.write_attribute(group, "time", time);
    replace_file(path, file.close_in_memory());
  }
  frames_.push_back(std::move(frame));
  write_index();
  frames_.back().description = xdmf_frame(Hdf5File::open(index()), six_digits(frames_.size() - 1));
  write_xdmf();
}

void FrameWriter::write_cloud(Hdf5File& file, const std::string& frame, const PointCloud& cloud,
                              std::vector<std::string>& topologies) {
  const std::string group = frame + "/" + cloud.name;
  file.create_group(group + "/fields");
  const bool in_double = precision_ == PositionPrecision::double_precision;
  if (in_double)
    file.write(group + "/positions", cloud.positions, {3});
  else
    file.write(group + "/positions", rounded(cloud.positions), {3});
  file.write_attribute(group, "position_bytes", std::int64_t{in_double ? 8 : 4});
  file.write_attribute(group, "topology", stored_topology(file, cloud, topologies));
  for (const auto& [name, values] : cloud.fields) {
    const std::string dataset = group + "/fields/" + name;
    if (values.size() == cloud.positions.size())
      file.write(dataset, rounded(values), {3});
    else
      file.write(dataset, rounded(values));
  }
}

std::string FrameWriter::stored_topology(Hdf5File& file, const PointCloud& cloud,
                                         std::vector<std::string>& topologies) {
  Topology& last = topologies_[cloud.name];
  std::vector<std::int32_t> corners = corners_of(cloud);
  const std::size_t points_per_cell = cloud.triangles.empty() ? 1 : 3;
  if (last.points_per_cell == points_per_cell && last.corners == corners) return last.dataset;
  const std::string dataset = "/topology/" + cloud.name + "/" + six_digits(frames_.size());
  file.write(dataset, corners, {points_per_cell});
  topologies.push_back(dataset);
  last = {points_per_cell, std::move(corners), dataset};
  return dataset;
}

void FrameWriter::write_cells(Hdf5File& file, const std::string& cells, const CellFields& fields) {
  const std::string group = cells + "/" + fields.name;
  file.create_group(group + "/fields");
  for (int axis = 0; axis < 3; ++axis)
    file.write(group + "/" + "xyz"[axis], fields.boundaries[axis]);
  const auto [nx, ny, nz] = cell_counts(fields);
  for (const auto& [name, values] : fields.fields) {
    const bool is_scalar = values.size() == nx * ny * nz;
    const auto layer = is_scalar ? std::vector{ny, nx} : std::vector{ny, nx, std::size_t{3}};
    file.write(group + "/fields/" + name, rounded(values), layer);
  }
}

void FrameWriter::write_index() const {
  Hdf5File file = Hdf5File::create_in_memory(index());
  file.create_group("/frames");
  file.create_group("/topology");
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    const std::string target = "fields/" + six_digits(f) + ".h5";
    file.link(frame_group(f), target);
    for (const std::string& dataset : frames_[f].topologies) file.link(dataset, target);
    if (frames_[f].has_cells) file.link(cells_group(f), target);
  }
  replace_file(index(), file.close_in_memory());
}

void FrameWriter::write_xdmf() const {
  std::string descriptions;
  for (const Frame& frame : frames_) descriptions += frame.description;
  replace_file(directory_ + "/fields.xdmf", xdmf_document(descriptions));
}

}  // namespace zona::mpm
