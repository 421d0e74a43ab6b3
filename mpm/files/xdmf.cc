#include "mpm/files/xdmf.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

namespace zona::mpm {

namespace {

std::string data_item(const Hdf5File& data, const std::string& dataset, const char* number,
                      std::int64_t bytes) {
  return fmt::format(
      R"(<DataItem Format="HDF" NumberType="{}" Precision="{}" Dimensions="{}">{}:{}</DataItem>)",
      number, bytes, fmt::join(data.shape(dataset), " "), frame_file("", dataset), dataset);
}

std::string topology(const Hdf5File& data, const std::string& cloud) {
  const auto dataset = data.read_attribute<std::string>(cloud, "topology");
  const std::vector<std::size_t> shape = data.shape(dataset);
  const char* type = shape.at(1) == 3 ? "Triangle" : "Polyvertex";
  return fmt::format(
      "<Topology TopologyType=\"{}\" NumberOfElements=\"{}\" "
      "NodesPerElement=\"{}\">{}</Topology>\n",
      type, shape.at(0), shape.at(1), data_item(data, dataset, "Int", 4));
}

/// All fields in a group. A scalar field has `dimensions` dimensions, a vector field one more.
std::string attributes(const Hdf5File& data, const std::string& fields, const char* center,
                       std::size_t dimensions) {
  std::string text;
  for (const std::string& name : data.children(fields)) {
    const std::string dataset = fields + "/" + name;
    const char* kind = data.shape(dataset).size() == dimensions ? "Scalar" : "Vector";
    text +=
        fmt::format("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
                    name, kind, center, data_item(data, dataset, "Float", 4));
  }
  return text;
}

std::string cloud_grid(const Hdf5File& data, const std::string& frame, const std::string& name) {
  const std::string cloud = frame + "/" + name;
  const auto position_bytes = data.read_attribute<std::int64_t>(cloud, "position_bytes");
  std::string text = fmt::format("<Grid Name=\"{}\" GridType=\"Uniform\">\n", name);
  text += topology(data, cloud);
  text += "<Geometry GeometryType=\"XYZ\">" +
          data_item(data, cloud + "/positions", "Float", position_bytes) + "</Geometry>\n";
  return text + attributes(data, cloud + "/fields", "Node", 1) + "</Grid>\n";
}

std::string cells_grid(const Hdf5File& data, const std::string& cells, const std::string& name) {
  const std::string group = cells + "/" + name;
  const auto boundaries = [&](const char* axis) { return group + "/" + axis; };
  const auto count = [&](const char* axis) { return data.shape(boundaries(axis)).at(0); };
  std::string text = fmt::format(
      "<Grid Name=\"{}\" GridType=\"Uniform\">\n"
      "<Topology TopologyType=\"3DRectMesh\" Dimensions=\"{} {} {}\"/>\n"
      "<Geometry GeometryType=\"VXVYVZ\">",
      name, count("z"), count("y"), count("x"));
  for (const char* axis : {"x", "y", "z"}) text += data_item(data, boundaries(axis), "Float", 8);
  return text + "</Geometry>\n" + attributes(data, group + "/fields", "Cell", 3) + "</Grid>\n";
}

}  // namespace

std::string frame_file(const std::string& index, const std::string& object) {
  // /frames/000012/..., /cells/000012/... or /topology/<cloud>/000012
  const bool is_topology = object.rfind("/topology/", 0) == 0;
  const std::size_t number = (is_topology ? object.find_last_of('/') : object.find('/', 1)) + 1;
  const auto folder = std::filesystem::path(index).parent_path() / "fields";
  return (folder / (object.substr(number, 6) + ".h5")).string();
}

std::string xdmf_frame(const Hdf5File& data, const std::string& number) {
  const std::string frame = "/frames/" + number;
  const std::string cells = "/cells/" + number;
  const auto time = data.read_attribute<double>(frame, "time");
  std::string text = fmt::format(
      "<Grid Name=\"bodies\" GridType=\"Collection\" CollectionType=\"Spatial\">\n"
      "<Time Value=\"{}\"/>\n",
      time);
  for (const std::string& cloud : data.children(frame)) text += cloud_grid(data, frame, cloud);
  if (data.contains(cells)) {
    for (const std::string& name : data.children(cells)) text += cells_grid(data, cells, name);
  }
  return text + "</Grid>\n";
}

std::string xdmf_document(const std::string& frames) {
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
         "<Grid Name=\"frames\" GridType=\"Collection\" CollectionType=\"Temporal\">\n" +
         frames + "</Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace zona::mpm
