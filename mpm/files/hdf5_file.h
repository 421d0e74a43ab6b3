#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace zona::mpm {

/// What went wrong in an HDF5 file; `what()` reads "file: object: problem (HDF5's own reason)".
class Hdf5Error : public std::runtime_error {
 public:
  /// `object` is empty for the file itself.
  Hdf5Error(const std::string& file, const std::string& object, const std::string& problem);
  /// Path of the file.
  const std::string& file() const { return file_; }
  /// The dataset, group or attribute concerned; empty when it is the file itself.
  const std::string& object() const { return object_; }

 private:
  std::string file_;
  std::string object_;
};

/// An open HDF5 file, closed when it goes out of scope.
///
/// Objects are named by absolute paths such as "/frames/000000/zona/positions"; missing groups on
/// the way are created by every write. Every member throws `Hdf5Error`. HDF5 prints nothing by
/// itself. Files are not locked, so that a viewer may read a file that a run appends to. MPI need
/// not be initialised. One thread at a time has files open, because HDF5 is not thread-safe; others
/// wait. A file is closed by the thread that opened it.
///
/// Element types T of datasets: double, float, std::int32_t, std::int64_t. Of attributes: double,
/// std::int64_t, std::string.
class Hdf5File {
 public:
  /// A new file; one of that name is replaced.
  static Hdf5File create(const std::string& path);
  /// A new file that stays in memory until `close_in_memory`; `path` is what it is called in
  /// errors.
  static Hdf5File create_in_memory(const std::string& path);
  /// An existing file, for reading only.
  static Hdf5File open(const std::string& path);
  /// An existing file, for reading and writing.
  static Hdf5File append(const std::string& path);

  /// @{
  /// The other stands for no file afterwards.
  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File& operator=(Hdf5File&& other) noexcept;
  /// @}
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  /// Closes the file and ignores failures; call `close` to hear of them.
  ~Hdf5File();

  /// Write a new one-dimensional dataset; one of that name must not exist.
  template <class T>
  void write(const std::string& dataset, const std::vector<T>& values);
  /// Write a new dataset of more dimensions, as many items of the shape `item` as there are values
  /// for: triples with {3}, layers of a grid with {rows, columns}. The last index runs fastest.
  template <class T>
  void write(const std::string& dataset, const std::vector<T>& values,
             const std::vector<std::size_t>& item);

  /// All values, row by row. Precision is converted to T's; integers are not read as floating point
  /// numbers nor the reverse.
  template <class T>
  std::vector<T> read(const std::string& dataset) const;
  /// The lengths of a dataset along its dimensions.
  std::vector<std::size_t> shape(const std::string& dataset) const;

  /// @{
  /// Write an attribute of a group or dataset, replacing one of that name.
  void write_attribute(const std::string& object, const std::string& name, double value);
  void write_attribute(const std::string& object, const std::string& name, std::int64_t value);
  void write_attribute(const std::string& object, const std::string& name,
                       const std::string& value);
  /// @}
  /// Value of an attribute, of the type that was written; texts of variable length are not read.
  template <class T>
  T read_attribute(const std::string& object, const std::string& name) const;
  /// Names of the attributes of an object, in alphabetical order.
  std::vector<std::string> attributes(const std::string& object) const;
  /// Whether an object has an attribute of that name.
  bool has_attribute(const std::string& object, const std::string& name) const;

  void create_group(const std::string& group);  ///< an empty one
  /// Lets `object` stand for the object of that path in another file, whose path is relative to
  /// this file's folder. That file need not exist before the object is asked for.
  void link(const std::string& object, const std::string& file);
  bool contains(const std::string& object) const;  ///< whether there is such a dataset or group
  /// Names (not paths) of what a group holds, in alphabetical order.
  std::vector<std::string> children(const std::string& group) const;
  /// Remove a dataset, or a group and all it holds. The space in the file is not reclaimed.
  void remove(const std::string& object);

  /// Hand everything written so far to the operating system.
  void flush();
  void close();  ///< for good; hears of failures
  /// Closes a file created in memory. Returns what it would have on a disk.
  std::string close_in_memory();

  const std::string& path() const { return path_; }  ///< as it was opened

 private:
  using Turn = std::unique_lock<std::recursive_mutex>;

  Hdf5File(Turn turn, std::string path, std::int64_t id);

  Turn turn_;  ///< to use HDF5
  std::string path_;
  std::int64_t id_ = -1;  ///< HDF5's handle; negative when closed
};

}  // namespace zona::mpm
