#pragma once

#include <string>

#include "mpm/hdf5_file.h"

namespace zona::mpm {

/// The file that holds a frame's group or a topology of it, both named after the frame: `index` is
/// DIRECTORY/fields.h5, the file is DIRECTORY/fields/000012.h5.
std::string frame_file(const std::string& index, const std::string& object);

/// XDMF description of one frame that `FrameWriter` stored as the group `frame`: a spatial
/// collection of its clouds, pointing to the files that hold them, relative to the index.
std::string xdmf_frame(const Hdf5File& index, const std::string& frame);

/// XDMF document of a temporal collection; `frames` is the descriptions, one after the other.
std::string xdmf_document(const std::string& frames);

}  // namespace zona::mpm
