#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace zona::mpm {

/// A failure in an HDF5 file; `what()` reads "file: object: problem (HDF5's own reason)".
class Hdf5Error : public std::runtime_error {
 public:
  /// `object` is empty for the file itself.
  Hdf5Error(const std::string& file, const std::string& object, const std::string& problem);
  /// Path of the file.
  const std::string& file() const { return file_; }
  /// The dataset, group or attribute; empty for the file itself.
  const std::string& object() const { return object_; }

 private:
  std::string file_;
  std::string object_;
};

/// An open HDF5 file, closed when it goes out of scope.
///
/// Objects have absolute paths such as "/frames/000000/zona/positions"; every write creates the
/// groups that are missing. Every member throws `Hdf5Error`. HDF5 itself prints nothing. Files are
/// not locked on the disk. MPI need not be initialised. HDF5 is not thread-safe: only one thread at
/// a time has files open, and others wait. The thread that opens a file must close it.
///
/// Element types T of datasets: double, float, std::int32_t, std::int64_t. Of attributes: double,
/// std::int64_t, std::string.
class Hdf5File {
 public:
  /// A new file; replaces an existing one.
  static Hdf5File create(const std::string& path);
  /// A new file that stays in memory until `close_in_memory`; `path` is its name in errors.
  static Hdf5File create_in_memory(const std::string& path);
  /// An existing file, for reading only.
  static Hdf5File open(const std::string& path);

  /// @{
  /// Leaves `other` without a file.
  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File& operator=(Hdf5File&& other) noexcept;
  /// @}
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  /// Closes the file and ignores failures; `close` reports them.
  ~Hdf5File();

  /// Writes a new one-dimensional dataset; throws if the name exists.
  template <class T>
  void write(const std::string& dataset, const std::vector<T>& values);
  /// Writes a new dataset of more dimensions: items of the shape `item`, one after the other, e.g.
  /// triples with {3}, layers of a grid with {rows, columns}. The last index runs fastest.
  template <class T>
  void write(const std::string& dataset, const std::vector<T>& values,
             const std::vector<std::size_t>& item);

  /// All values, row by row, converted to the precision of T. Throws if one of file and T has
  /// integers and the other floating point numbers.
  template <class T>
  std::vector<T> read(const std::string& dataset) const;
  /// Lengths of a dataset along its dimensions.
  std::vector<std::size_t> shape(const std::string& dataset) const;

  /// @{
  /// Writes an attribute of a group or dataset; replaces an existing one.
  void write_attribute(const std::string& object, const std::string& name, double value);
  void write_attribute(const std::string& object, const std::string& name, std::int64_t value);
  void write_attribute(const std::string& object, const std::string& name,
                       const std::string& value);
  /// @}
  /// Value of an attribute, of the type that was written. Throws for texts of variable length.
  template <class T>
  T read_attribute(const std::string& object, const std::string& name) const;
  /// Names of the attributes of an object, in alphabetical order.
  std::vector<std::string> attributes(const std::string& object) const;

  void create_group(const std::string& group);  ///< an empty group
  /// Makes `object` an external link to the same path in another file, which is given relative to
  /// this file's folder. That file need not exist until the object is read.
  void link(const std::string& object, const std::string& file);
  bool contains(const std::string& object) const;  ///< true if the dataset or group exists
  /// Names (not paths) of the members of a group, in alphabetical order.
  std::vector<std::string> children(const std::string& group) const;

  void close();  ///< reports failures, which the destructor does not
  /// Closes a file created in memory. Returns its bytes.
  std::string close_in_memory();

  const std::string& path() const { return path_; }  ///< as it was opened

 private:
  using Lock = std::unique_lock<std::recursive_mutex>;

  Hdf5File(Lock lock, std::string path, std::int64_t id);

  Lock lock_;  ///< on HDF5
  std::string path_;
  std::int64_t id_ = -1;  ///< HDF5's handle; negative when closed
};

}  // namespace zona::mpm
