#pragma once

#include <string>

#include "mpm/hdf5_file.h"

namespace zona::mpm {

/// XDMF description of one frame that `FrameWriter` stored as the group `frame`: a spatial
/// collection of its clouds, pointing to the data by the file's name without its folder.
std::string xdmf_frame(const Hdf5File& data, const std::string& frame);

/// XDMF document of a temporal collection; `frames` is the descriptions, one after the other.
std::string xdmf_document(const std::string& frames);

}  // namespace zona::mpm
