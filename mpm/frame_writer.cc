#include "mpm/frame_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "mpm/atomic_file.h"
#include "mpm/xdmf.h"

namespace zona::mpm {

namespace {

[[noreturn]] void refuse(const std::string& cloud, const std::string& problem) {
  throw std::invalid_argument(fmt::format("frame: cloud '{}': {}", cloud, problem));
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
      refuse(cloud.name, fmt::format("field '{}' has {} values for {} points; one or three a point "
                                     "are wanted",
                                     name, values.size(), points));
  }
}

std::vector<float> rounded(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

/// Indices of the points that make up the cells of a cloud: three a triangle, or each point alone.
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

}  // namespace

FrameWriter::FrameWriter(std::string directory, PositionPrecision precision,
                         std::size_t frame_count)
    : directory_(std::move(directory)),
      precision_(precision),
      frame_count_(frame_count),
      last_time_(-std::numeric_limits<double>::infinity()) {}

FrameWriter::FrameWriter(const std::string& directory, PositionPrecision precision)
    : FrameWriter(directory, precision, 0) {
  Hdf5File file = Hdf5File::create(data_path());
  file.create_group("/frames");
  file.create_group("/topology");
  file.close();
  write_xdmf();
}

FrameWriter FrameWriter::resume(const std::string& directory, double last_time,
                                PositionPrecision precision) {
  FrameWriter writer(directory, precision, 0);
  writer.keep_frames(last_time);
  writer.write_xdmf();
  return writer;
}

void FrameWriter::keep_frames(double last_time) {
  Hdf5File file = Hdf5File::append(data_path());
  bool keep = true;
  for (const std::string& name : file.children("/frames")) {
    const std::string frame = "/frames/" + name;
    keep = keep && file.has_attribute(frame, "time") &&
           file.read_attribute<double>(frame, "time") <= last_time;
    if (!keep) {
      file.remove(frame);
      continue;
    }
    last_time_ = file.read_attribute<double>(frame, "time");
    xdmf_frames_ += xdmf_frame(file, frame);
    ++frame_count_;
  }
  for (const std::string& cloud : file.children("/topology"))
    for (const std::string& name : file.children("/topology/" + cloud))
      if (name >= six_digits(frame_count_)) file.remove("/topology/" + cloud + "/" + name);
  file.close();
}

void FrameWriter::check_frame(double time, const std::vector<PointCloud>& clouds) const {
  if (!std::isfinite(time) || time <= last_time_)
    throw std::invalid_argument(fmt::format(
        "frame: time {} s must be finite and after the frame before, at {} s", time, last_time_));
  std::set<std::string> names;
  for (const PointCloud& cloud : clouds) {
    check_cloud(cloud);
    if (!names.insert(cloud.name).second) refuse(cloud.name, "occurs twice");
  }
}

void FrameWriter::add_frame(double time, const std::vector<PointCloud>& clouds) {
  check_frame(time, clouds);
  const std::string frame = frame_group(frame_count_);
  Hdf5File file = Hdf5File::append(data_path());
  if (file.contains(frame)) file.remove(frame);  // left by a write that failed
  file.create_group(frame);
  for (const PointCloud& cloud : clouds)
    if (!cloud.positions.empty()) write_cloud(file, frame, cloud);
  file.write_attribute(frame, "time", time);
  const std::string description = xdmf_frame(file, frame);
  file.close();
  xdmf_frames_ += description;
  last_time_ = time;
  ++frame_count_;
  write_xdmf();
}

void FrameWriter::write_cloud(Hdf5File& file, const std::string& frame, const PointCloud& cloud) {
  const std::string group = frame + "/" + cloud.name;
  file.create_group(group + "/fields");
  const bool in_double = precision_ == PositionPrecision::double_precision;
  if (in_double)
    file.write(group + "/positions", cloud.positions, 3);
  else
    file.write(group + "/positions", rounded(cloud.positions), 3);
  file.write_attribute(group, "position_bytes", std::int64_t{in_double ? 8 : 4});
  file.write_attribute(group, "topology", stored_topology(file, frame, cloud));
  for (const auto& [name, values] : cloud.fields) {
    const std::string dataset = group + "/fields/" + name;
    if (values.size() == cloud.positions.size())
      file.write(dataset, rounded(values), 3);
    else
      file.write(dataset, rounded(values));
  }
}

std::string FrameWriter::stored_topology(Hdf5File& file, const std::string& frame,
                                         const PointCloud& cloud) {
  Topology& last = topologies_[cloud.name];
  std::vector<std::int32_t> corners = corners_of(cloud);
  const std::size_t points_a_cell = cloud.triangles.empty() ? 1 : 3;
  if (last.points_a_cell == points_a_cell && last.corners == corners) return last.dataset;
  const std::string dataset =
      "/topology/" + cloud.name + "/" + frame.substr(frame.find_last_of('/') + 1);
  if (file.contains(dataset)) file.remove(dataset);  // left by a write that failed
  file.write(dataset, corners, points_a_cell);
  last = {points_a_cell, std::move(corners), dataset};
  return dataset;
}

void FrameWriter::write_xdmf() const {
  replace_file(directory_ + "/fields.xdmf", xdmf_document(xdmf_frames_));
}

std::string FrameWriter::data_path() const {
  return directory_ + "/fields.h5";
}

}  // namespace zona::mpm
