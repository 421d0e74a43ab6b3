#pragma once

#include <string>

#include "mpm/files/hdf5_file.h"

namespace zona::mpm {

/// The file that holds a frame's group, its cells or a topology of it, all named after the frame:
/// `index` is DIRECTORY/fields.h5, the file is DIRECTORY/fields/000012.h5.
std::string frame_file(const std::string& index, const std::string& object);

/// XDMF description of the frame that `FrameWriter` stored under a number such as "000012": a
/// spatial collection of its clouds and cells, pointing to the files that hold them, relative to
/// the index.
std::string xdmf_frame(const Hdf5File& index, const std::string& number);

/// XDMF document of a temporal collection; `frames` is the descriptions, one after the other.
std::string xdmf_document(const std::string& frames);

}  // namespace zona::mpm
