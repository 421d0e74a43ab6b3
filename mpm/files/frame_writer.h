#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mpm/files/hdf5_file.h"

namespace zona::mpm {

/// One body at one instant, for a viewer: points, or a triangle mesh over them.
struct PointCloud {
  std::string name;                           ///< letters, digits, `_`, `-`
  std::vector<double> positions;              ///< x y z of point 0, of point 1, ... [m]
  std::vector<std::array<int, 3>> triangles;  ///< indices of points; empty for points alone
  /// Values at the points [SI units]: one per point, or three (a vector, interleaved).
  std::map<std::string, std::vector<double>> fields;
};

/// Averages over the cells of a grid at one instant.
struct CellFields {
  std::string name;                               ///< letters, digits, `_`, `-`
  std::array<std::vector<double>, 3> boundaries;  ///< of the cells along x, y, z, ascending [m]
  /// Values of the cells [SI units], x fastest, then y: one per cell, or three (a vector,
  /// interleaved). NaN in empty cells.
  std::map<std::string, std::vector<double>> fields;
};

/// Precision of the stored positions. Single precision resolves 1e-11 m in a domain of 100 um and
/// halves the file. Fields are always stored in single precision, times in double.
enum class PositionPrecision { single_precision, double_precision };

/// Writes instants ("frames") of a run, each to a file of its own, `fields/000000.h5`, ..., and two
/// files that join them: `fields.h5` for programs and `fields.xdmf` for viewers, a temporal
/// collection of spatial collections. ParaView opens it with its readers "XDMF Reader" and "Xdmf3
/// Reader T".
///
/// Every file is written under a temporary name and then renamed. A run can be viewed while it
/// continues and killed at any moment: complete frames stay complete. `fields.h5` links to the
/// frames:
///
///     /frames/000000            attribute "time" [s]
///     /frames/000000/<cloud>/positions        (points, 3)
///     /frames/000000/<cloud>/fields/<field>   (points) or (points, 3)
///     /topology/<cloud>/000000                (triangles, 3), or (points, 1) for points alone
///     /cells/000000/<name>/x, y, z            boundaries of the cells, (cells along the axis + 1)
///     /cells/000000/<name>/fields/<field>     (cells z, y, x) or (cells z, y, x, 3)
///
/// A topology is named after its first frame and written again only in frames where it has changed;
/// each cloud's group names it in the attribute "topology". (Points alone have a topology that
/// counts them, because ParaView needs one to draw them.) Empty clouds are left out.
///
/// Members throw `Hdf5Error` and `FileError` when files fail, and `std::invalid_argument` when a
/// cloud is inconsistent; then no part of the frame has been written.
class FrameWriter {
 public:
  /// Starts a new series in an existing directory and replaces the files of an earlier run.
  explicit FrameWriter(const std::string& directory,
                       PositionPrecision precision = PositionPrecision::single_precision);

  /// Continues the files of an interrupted run: keeps its frames up to `last_time` [s] and removes
  /// later ones. The files end up as they would without the interruption.
  static FrameWriter resume(const std::string& directory, double last_time,
                            PositionPrecision precision = PositionPrecision::single_precision);

  /// Adds the frame at `time` [s], which must be later than the frame before. Clouds and cells must
  /// have different names.
  void add_frame(double time, const std::vector<PointCloud>& clouds,
                 const std::vector<CellFields>& cells = {});

  /// Frames written so far, including those that `resume` kept.
  std::size_t frame_count() const { return frames_.size(); }

 private:
  struct Topology {
    std::size_t points_per_cell = 0;
    std::vector<std::int32_t> corners;
    std::string dataset;
  };

  struct Frame {
    double time;
    std::vector<std::string> topologies;  ///< datasets that this frame stores
    bool has_cells;
    std::string description;  ///< for fields.xdmf
  };

  FrameWriter(std::string directory, PositionPrecision precision, std::vector<Frame> frames);
  static std::vector<Frame> stored_frames(const std::string& directory, double last_time);
  void check_frame(double time, const std::vector<PointCloud>& clouds,
                   const std::vector<CellFields>& cells) const;
  void write_cloud(Hdf5File& file, const std::string& frame, const PointCloud& cloud,
                   std::vector<std::string>& topologies);
  std::string stored_topology(Hdf5File& file, const PointCloud& cloud,
                              std::vector<std::string>& topologies);
  static void write_cells(Hdf5File& file, const std::string& cells, const CellFields& fields);
  void load_topologies();
  void write_index() const;
  void write_xdmf() const;
  std::string index() const { return directory_ + "/fields.h5"; }

  std::string directory_;
  PositionPrecision precision_;
  std::vector<Frame> frames_;
  std::map<std::string, Topology> topologies_;  ///< last written, by cloud
};

}  // namespace zona::mpm
