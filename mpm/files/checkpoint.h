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

/// What a checkpoint says of itself, e.g. "version": "0.1.0".
using CheckpointLabels = std::map<std::string, std::string>;
/// Shows the visitor all state.
using VisitState = std::function<void(StateVisitor&)>;

/// A state, stored so that it can be trusted: an HDF5 file, followed by a hash of all its bytes. It
/// gets its name when it is whole and on the disk; a process that is killed before leaves a file
/// ending in ".tmp". Throws `CheckpointError`, `FileError`, `Hdf5Error`.
void write_checkpoint(const std::string& path, const CheckpointLabels& labels,
                      const VisitState& visit);

/// A stored state. Throws `CheckpointError` for a file that is not there, not whole or not what was
/// written.
class Checkpoint {
 public:
  /// Reads the file and holds its hash against its bytes.
  explicit Checkpoint(const std::string& path);

  const CheckpointLabels& labels() const { return labels_; }  ///< as they were written
  /// Gives everything its stored value. Throws `CheckpointError` for what is not stored or has
  /// another size.
  void restore(const VisitState& visit) const;

 private:
  std::string path_;
  CheckpointLabels labels_;
};

}  // namespace zona::mpm
