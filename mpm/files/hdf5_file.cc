#include "mpm/files/hdf5_file.h"

#include "mpm/files/hdf5_handle.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <type_traits>
#include <utility>

namespace zona::mpm {

namespace {

using hdf5::check;
using hdf5::Handle;
using hdf5::QuietScope;

static_assert(std::is_same_v<hid_t, std::int64_t>, "the header stores HDF5's handles as int64");

/// Locks HDF5 for this thread.
std::unique_lock<std::recursive_mutex> lock_hdf5() {
  static std::recursive_mutex mutex;
  return std::unique_lock(mutex);
}

template <class T>
hid_t native_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
  if constexpr (std::is_same_v<T, std::int32_t>) return H5T_NATIVE_INT32;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
}

hid_t unlocked_access() {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_file_locking(access, false, true);
  return access;
}

template <class T>
void write_dataset(hid_t file, const std::string& path, const std::string& dataset, const T* values,
                   const std::vector<hsize_t>& shape) {
  const QuietScope quiet;
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose);
  // Without a time stamp the same data make the same file.
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  const Handle data(
      H5Dcreate2(file, dataset.c_str(), native_type<T>(), space, links, creation, H5P_DEFAULT),
      H5Dclose);
  check<hid_t>(data, path, dataset, "cannot create the dataset");
  check(H5Dwrite(data, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path, dataset,
        "cannot write the dataset");
}

std::vector<hsize_t> shape_of(hid_t data, const std::string& path, const std::string& dataset) {
  const Handle space(H5Dget_space(data), H5Sclose);
  const int rank = check(H5Sget_simple_extent_ndims(space), path, dataset, "has no dimensions");
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space, shape.data(), nullptr), path, dataset,
        "has no dimensions");
  return shape;
}

/// Throws unless the stored numbers and T are both integers or both floating point.
template <class T>
void check_class(hid_t data, const std::string& path, const std::string& dataset) {
  const Handle type(H5Dget_type(data), H5Tclose);
  const bool integers = H5Tget_class(type) == H5T_INTEGER;
  const bool reals = H5Tget_class(type) == H5T_FLOAT;
  if (std::is_integral_v<T> ? !integers : !reals)
    throw Hdf5Error(path, dataset,
                    std::string("does not hold ") +
                        (std::is_integral_v<T> ? "integers" : "floating point numbers"));
}

/// Number of values in a dataset. Throws if the file claims more than its bytes can hold: deflate,
/// the strongest of HDF5's filters, expands one byte to at most 1032.
std::size_t count_of(hid_t data, const std::string& path, const std::string& dataset) {
  constexpr double max_expansion = 1032;
  std::size_t count = 1;
  double product = 1;
  for (const hsize_t length : shape_of(data, path, dataset)) {
    count *= length;
    product *= static_cast<double>(length);
  }
  const Handle type(H5Dget_type(data), H5Tclose);
  const Handle file(H5Iget_file_id(data), H5Fclose);
  hsize_t file_size = 0;
  check(H5Fget_filesize(file, &file_size), path, dataset, "cannot read the size of its file");
  if (product * static_cast<double>(H5Tget_size(type)) >
      max_expansion * static_cast<double>(file_size)) {
    throw Hdf5Error(path, dataset,
                    "claims to have " + std::to_string(product) +
                        " values, more than its file of " + std::to_string(file_size) +
                        " bytes can hold");
  }
  return count;
}

}  // namespace

Hdf5Error::Hdf5Error(const std::string& file, const std::string& object, const std::string& problem)
    : std::runtime_error(file + ": " + (object.empty() ? "" : object + ": ") + problem),
      file_(file),
      object_(object) {}

Hdf5File::Hdf5File(Lock lock, std::string path, std::int64_t id)
    : lock_(std::move(lock)), path_(std::move(path)), id_(id) {}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : lock_(std::move(other.lock_)),
      path_(std::move(other.path_)),
      id_(std::exchange(other.id_, -1)) {}

Hdf5File& Hdf5File::operator=(Hdf5File&& other) noexcept {
  std::swap(lock_, other.lock_);
  std::swap(path_, other.path_);
  std::swap(id_, other.id_);
  return *this;
}

Hdf5File::~Hdf5File() {
  if (id_ < 0) return;
  const QuietScope quiet;
  H5Fclose(id_);
}

Hdf5File Hdf5File::create(const std::string& path) {
  Lock lock = lock_hdf5();
  const QuietScope quiet;
  const Handle access(unlocked_access(), H5Pclose);
  const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  return Hdf5File(std::move(lock), path, check(id, path, "", "cannot create the file"));
}

Hdf5File Hdf5File::create_in_memory(const std::string& path) {
  constexpr std::size_t growth = 4 << 20;
  Lock lock = lock_hdf5();
  const QuietScope quiet;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access, growth, false);
  const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  return Hdf5File(std::move(lock), path, check(id, path, "", "cannot create the file in memory"));
}

Hdf5File Hdf5File::open(const std::string& path) {
  Lock lock = lock_hdf5();
  const QuietScope quiet;
  const Handle access(unlocked_access(), H5Pclose);
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  return Hdf5File(std::move(lock), path, check(id, path, "", "cannot open the file"));
}

template <class T>
void Hdf5File::write(const std::string& dataset, const std::vector<T>& values) {
  write_dataset(id_, path_, dataset, values.data(), {values.size()});
}

template <class T>
void Hdf5File::write(const std::string& dataset, const std::vector<T>& values,
                     const std::vector<std::size_t>& item) {
  const std::size_t size =
      std::accumulate(item.begin(), item.end(), std::size_t{1}, std::multiplies<>());
  if (size == 0 || values.size() % size != 0)
    throw Hdf5Error(
        path_, dataset,
        std::to_string(values.size()) + " values do not fill rows of " + std::to_string(size));
  std::vector<hsize_t> shape{values.size() / size};
  shape.insert(shape.end(), item.begin(), item.end());
  write_dataset(id_, path_, dataset, values.data(), shape);
}

template <class T>
std::vector<T> Hdf5File::read(const std::string& dataset) const {
  const QuietScope quiet;
  const Handle data(H5Dopen2(id_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  check<hid_t>(data, path_, dataset, "cannot open the dataset");
  check_class<T>(data, path_, dataset);
  std::vector<T> values(count_of(data, path_, dataset));
  check(H5Dread(data, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path_,
        dataset, "cannot read the dataset");
  return values;
}

std::vector<std::size_t> Hdf5File::shape(const std::string& dataset) const {
  const QuietScope quiet;
  const Handle data(H5Dopen2(id_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  check<hid_t>(data, path_, dataset, "cannot open the dataset");
  const std::vector<hsize_t> lengths = shape_of(data, path_, dataset);
  return {lengths.begin(), lengths.end()};
}

void Hdf5File::create_group(const std::string& group) {
  const QuietScope quiet;
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  const Handle created(H5Gcreate2(id_, group.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  check<hid_t>(created, path_, group, "cannot create the group");
}

void Hdf5File::link(const std::string& object, const std::string& file) {
  const QuietScope quiet;
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  check(H5Lcreate_external(file.c_str(), object.c_str(), id_, object.c_str(), links, H5P_DEFAULT),
        path_, object, "cannot create the link");
}

bool Hdf5File::contains(const std::string& object) const {
  const QuietScope quiet;
  const Handle found(H5Oopen(id_, object.c_str(), H5P_DEFAULT), H5Oclose);
  return found >= 0;
}

std::vector<std::string> Hdf5File::children(const std::string& group) const {
  const QuietScope quiet;
  const Handle parent(H5Gopen2(id_, group.c_str(), H5P_DEFAULT), H5Gclose);
  check<hid_t>(parent, path_, group, "cannot open the group");
  std::vector<std::string> names;
  const auto append_name = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  check(H5Literate(parent, H5_INDEX_NAME, H5_ITER_INC, nullptr, append_name, &names), path_, group,
        "cannot list the group");
  return names;
}

void Hdf5File::close() {
  if (id_ < 0) return;
  const Lock lock = std::move(lock_);
  const QuietScope quiet;
  check(H5Fclose(std::exchange(id_, -1)), path_, "", "cannot close the file");
}

std::string Hdf5File::close_in_memory() {
  std::string bytes;
  {
    const QuietScope quiet;
    check(H5Fflush(id_, H5F_SCOPE_GLOBAL), path_, "", "cannot complete the file");
    bytes.resize(static_cast<std::size_t>(
        check(H5Fget_file_image(id_, nullptr, 0), path_, "", "cannot complete the file")));
    check(H5Fget_file_image(id_, bytes.data(), bytes.size()), path_, "",
          "cannot complete the file");
  }
  close();
  return bytes;
}

template void Hdf5File::write(const std::string&, const std::vector<double>&);
template void Hdf5File::write(const std::string&, const std::vector<double>&,
                              const std::vector<std::size_t>&);
template std::vector<double> Hdf5File::read(const std::string&) const;
template void Hdf5File::write(const std::string&, const std::vector<float>&);
template void Hdf5File::write(const std::string&, const std::vector<float>&,
                              const std::vector<std::size_t>&);
template std::vector<float> Hdf5File::read(const std::string&) const;
template void Hdf5File::write(const std::string&, const std::vector<std::int32_t>&);
template void Hdf5File::write(const std::string&, const std::vector<std::int32_t>&,
                              const std::vector<std::size_t>&);
template std::vector<std::int32_t> Hdf5File::read(const std::string&) const;
template void Hdf5File::write(const std::string&, const std::vector<std::int64_t>&);
template void Hdf5File::write(const std::string&, const std::vector<std::int64_t>&,
                              const std::vector<std::size_t>&);
template std::vector<std::int64_t> Hdf5File::read(const std::string&) const;

}  // namespace zona::mpm
