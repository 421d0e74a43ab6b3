#pragma once

#include <string>

#include "mpm/files/hdf5_file.h"

namespace zona::mpm {

/// Path of the file that holds `object`: the group, the cells or a topology of a frame. For the
/// index DIRECTORY/fields.h5 and frame 12 it is DIRECTORY/fields/000012.h5.
std::string frame_file(const std::string& index, const std::string& object);

/// XDMF description of the frame that `FrameWriter` stored under a number such as "000012": a
/// spatial collection of its clouds and cells that points to their files, relative to the index.
std::string xdmf_frame(const Hdf5File& index, const std::string& number);

/// XDMF document of a temporal collection; `frames` are the descriptions, one after the other.
std::string xdmf_document(const std::string& frames);

}  // namespace zona::mpm
