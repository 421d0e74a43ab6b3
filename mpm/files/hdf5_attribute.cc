#include <algorithm>
#include <type_traits>

#include "mpm/files/hdf5_file.h"
#include "mpm/files/hdf5_handle.h"

namespace zona::mpm {

namespace {

using hdf5::check;
using hdf5::Handle;
using hdf5::QuietScope;

hid_t attribute_type(const std::string& value) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, std::max<std::size_t>(1, value.size()));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}
hid_t attribute_type(double) {
  return H5Tcopy(H5T_NATIVE_DOUBLE);
}
hid_t attribute_type(std::int64_t) {
  return H5Tcopy(H5T_NATIVE_INT64);
}

template <class T>
herr_t write_attribute_value(hid_t attribute, hid_t type, const T& value) {
  if constexpr (std::is_same_v<T, std::string>)
    return H5Awrite(attribute, type, value.c_str());
  else
    return H5Awrite(attribute, type, &value);
}

template <class T>
void write_attribute_of(hid_t file, const std::string& path, const std::string& object,
                        const std::string& name, const T& value) {
  const QuietScope quiet;
  const std::string label = object + "@" + name;
  const Handle owner(H5Oopen(file, object.c_str(), H5P_DEFAULT), H5Oclose);
  check<hid_t>(owner, path, label, "cannot open the object of the attribute");
  if (H5Aexists(owner, name.c_str()) > 0) H5Adelete(owner, name.c_str());
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle type(attribute_type(value), H5Tclose);
  const Handle attribute(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  check<hid_t>(attribute, path, label, "cannot create the attribute");
  check(write_attribute_value(attribute, type, value), path, label, "cannot write the attribute");
}

template <class T>
constexpr H5T_class_t attribute_class() {
  if (std::is_same_v<T, std::string>) return H5T_STRING;
  return std::is_same_v<T, double> ? H5T_FLOAT : H5T_INTEGER;
}

/// True if a stored type can be read as T. Texts must have a fixed length, as this class writes
/// them: in a damaged file HDF5 1.10 may follow a text of variable length forever.
template <class T>
bool is_readable(hid_t type) {
  constexpr std::size_t max_text_size = 1 << 20;  // far more than an attribute needs
  if (H5Tget_class(type) != attribute_class<T>()) return false;
  return !std::is_same_v<T, std::string> ||
         (H5Tis_variable_str(type) == 0 && H5Tget_size(type) <= max_text_size);
}

herr_t read_attribute_value(hid_t attribute, hid_t type, std::string& value) {
  value.assign(H5Tget_size(type), '\0');
  const herr_t answer = H5Aread(attribute, type, value.data());
  value.resize(std::min(value.size(), value.find('\0')));
  return answer;
}
template <class T>
herr_t read_attribute_value(hid_t attribute, hid_t, T& value) {
  const Handle type(attribute_type(value), H5Tclose);
  return H5Aread(attribute, type, &value);
}

}  // namespace

void Hdf5File::write_attribute(const std::string& object, const std::string& name, double value) {
  write_attribute_of(id_, path_, object, name, value);
}
void Hdf5File::write_attribute(const std::string& object, const std::string& name,
                               std::int64_t value) {
  write_attribute_of(id_, path_, object, name, value);
}
void Hdf5File::write_attribute(const std::string& object, const std::string& name,
                               const std::string& value) {
  write_attribute_of(id_, path_, object, name, value);
}

template <class T>
T Hdf5File::read_attribute(const std::string& object, const std::string& name) const {
  const QuietScope quiet;
  const std::string label = object + "@" + name;
  const Handle attribute(
      H5Aopen_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  check<hid_t>(attribute, path_, label, "cannot open the attribute");
  const Handle type(H5Aget_type(attribute), H5Tclose);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  if (!is_readable<T>(type) || H5Sget_simple_extent_npoints(space) != 1)
    throw Hdf5Error(path_, label, "is not of the requested type");
  T value{};
  check(read_attribute_value(attribute, type, value), path_, label, "cannot read the attribute");
  return value;
}

std::vector<std::string> Hdf5File::attributes(const std::string& object) const {
  const QuietScope quiet;
  const Handle owner(H5Oopen(id_, object.c_str(), H5P_DEFAULT), H5Oclose);
  check<hid_t>(owner, path_, object, "cannot open the object");
  std::vector<std::string> names;
  const auto append_name = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  check(H5Aiterate2(owner, H5_INDEX_NAME, H5_ITER_INC, nullptr, append_name, &names), path_, object,
        "cannot list the attributes");
  return names;
}

template double Hdf5File::read_attribute(const std::string&, const std::string&) const;
template std::int64_t Hdf5File::read_attribute(const std::string&, const std::string&) const;
template std::string Hdf5File::read_attribute(const std::string&, const std::string&) const;

}  // namespace zona::mpm
