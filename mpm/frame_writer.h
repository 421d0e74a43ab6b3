#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mpm/hdf5_file.h"

namespace zona::mpm {

/// What is drawn of one body at one instant: points, or a triangle mesh over them.
struct PointCloud {
  std::string name;                           ///< letters, digits, `_`, `-`
  std::vector<double> positions;              ///< x y z of point 0, of point 1, ... [m]
  std::vector<std::array<int, 3>> triangles;  ///< indices of points; empty for a mere cloud
  /// Values at the points [SI units]: one a point, or three (a vector, interleaved).
  std::map<std::string, std::vector<double>> fields;
};

/// How many digits of the positions are kept. Single precision resolves 1e-11 m in a domain of
/// 100 um and halves the file. Fields are always stored in single precision, times in double.
enum class PositionPrecision { single_precision, double_precision };

/// Writes instants ("frames") of a run to `fields.h5` and `fields.xdmf`, a temporal collection of
/// spatial collections. ParaView opens it with its readers "XDMF Reader" and "Xdmf3 Reader T".
///
/// Both files are complete and closed between frames, so a run may be watched while it goes on and
/// loses at most one frame when it is killed. The XDMF file is replaced atomically, after the data
/// that it points to are in `fields.h5`:
///
///     /frames/000000            attribute "time" [s], written last: a frame without it is broken
///     /frames/000000/<cloud>/positions        (points, 3)
///     /frames/000000/<cloud>/fields/<field>   (points) or (points, 3)
///     /topology/<cloud>/000000                (triangles, 3), or (points, 1) for a mere cloud
///
/// The topology, named after its first frame, is written again only in frames where it differs from
/// the last written; each cloud's group names it in the attribute "topology". (That of a mere cloud
/// only counts its points, which ParaView would not draw without.) Empty clouds are left out.
///
/// Members throw `Hdf5Error` and `FileError` when files fail, `std::invalid_argument` when a cloud
/// is inconsistent; then nothing of the frame has been written.
class FrameWriter {
 public:
  /// Starts anew in an existing directory, replacing files of an earlier run.
  explicit FrameWriter(const std::string& directory,
                       PositionPrecision precision = PositionPrecision::single_precision);

  /// Goes on with the files of an interrupted run: its frames up to `last_time` [s] are kept,
  /// later and broken ones removed.
  static FrameWriter resume(const std::string& directory, double last_time,
                            PositionPrecision precision = PositionPrecision::single_precision);

  /// Adds the frame at `time` [s], which must be later than the frame before.
  void add_frame(double time, const std::vector<PointCloud>& clouds);

  std::size_t frame_count() const { return frame_count_; }

 private:
  struct Topology {
    std::size_t points_a_cell = 0;
    std::vector<std::int32_t> corners;
    std::string dataset;
  };

  FrameWriter(std::string directory, PositionPrecision precision, std::size_t frame_count);
  void check_frame(double time, const std::vector<PointCloud>& clouds) const;
  void write_cloud(Hdf5File& file, const std::string& frame, const PointCloud& cloud);
  std::string stored_topology(Hdf5File& file, const std::string& frame, const PointCloud& cloud);
  void keep_frames(double last_time);
  void write_xdmf() const;
  std::string data_path() const;

  std::string directory_;
  PositionPrecision precision_;
  std::size_t frame_count_ = 0;
  double last_time_;
  std::map<std::string, Topology> topologies_;  ///< last written, by cloud
  std::string xdmf_frames_;                     ///< the XDMF text of all frames so far
};

}  // namespace zona::mpm
