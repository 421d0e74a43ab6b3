#pragma once

#include <hdf5.h>

#include "tests/fuzz/input_file.h"

namespace zona::tests {

/// HDF5 owns what its handles stand for, and no leak checker notices a forgotten one. This does:
/// all files and what was opened in them must be closed when it goes.
class Hdf5Handles {
 public:
  Hdf5Handles() = default;
  ~Hdf5Handles() {
    if (H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_ALL) != 0) broken("all handles of HDF5 are closed");
  }
  Hdf5Handles(const Hdf5Handles&) = delete;
  Hdf5Handles& operator=(const Hdf5Handles&) = delete;
};

}  // namespace zona::tests
