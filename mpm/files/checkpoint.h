#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "mpm/files/hdf5_file.h"
#include "mpm/points/state_visitor.h"

namespace zona::mpm {

/// A checkpoint cannot be written or used; `what()` names the file and the reason.
class CheckpointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Describes a checkpoint, e.g. "version": "0.1.0".
using CheckpointLabels = std::map<std::string, std::string>;
/// Passes all state to the visitor.
using VisitState = std::function<void(StateVisitor&)>;

/// Stores a state as an HDF5 file followed by a hash of all its bytes. The file gets its name once
/// it is complete and on the disk; a process killed earlier leaves a file ending in ".tmp". Throws
/// `CheckpointError`, `FileError`, `Hdf5Error`.
void write_checkpoint(const std::string& path, const CheckpointLabels& labels,
                      const VisitState& visit);

/// A stored state. Throws `CheckpointError` for a file that is missing, incomplete or damaged.
class Checkpoint {
 public:
  /// Reads the file and checks its hash.
  explicit Checkpoint(const std::string& path);

  const CheckpointLabels& labels() const { return labels_; }  ///< as they were written
  /// Sets all state to the stored values. Throws `CheckpointError` for a value that is not stored
  /// or has another size.
  void restore(const VisitState& visit) const;

 private:
  std::string path_;
  CheckpointLabels labels_;
};

}  // namespace zona::mpm
