#include "mpm/files/checkpoint.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>

#include "mpm/files/atomic_file.h"
#include "mpm/files/read_file.h"

namespace zona::mpm {

namespace {

/// Every checkpoint ends with this word and the hash of all bytes before it.
constexpr std::string_view end_word = "ZONAHASH";
constexpr std::size_t end_size = end_word.size() + sizeof(XXH64_hash_t);

std::string end_of(std::string_view bytes) {
  const XXH64_hash_t hash = XXH3_64bits(bytes.data(), bytes.size());
  std::string end(end_word);
  end.resize(end_size);
  std::memcpy(&end[end_word.size()], &hash, sizeof hash);
  return end;
}

class StoreVisitor : public StateVisitor {
 public:
  explicit StoreVisitor(Hdf5File& file) : file_(file) {}
  bool is_restoring() const override { return false; }
  void visit(const std::string& name, double* values, std::size_t count) override {
    store(name, values, count);
  }
  void visit(const std::string& name, std::int32_t* values, std::size_t count) override {
    store(name, values, count);
  }
  void visit(const std::string& name, std::int64_t* values, std::size_t count) override {
    store(name, values, count);
  }

 private:
  template <class T>
  void store(const std::string& name, const T* values, std::size_t count) {
    file_.write("/state/" + name, std::vector<T>(values, values + count));
  }
  Hdf5File& file_;
};

class RestoreVisitor : public StateVisitor {
 public:
  explicit RestoreVisitor(const Hdf5File& file) : file_(file) {}
  bool is_restoring() const override { return true; }
  void visit(const std::string& name, double* values, std::size_t count) override {
    restore(name, values, count);
  }
  void visit(const std::string& name, std::int32_t* values, std::size_t count) override {
    restore(name, values, count);
  }
  void visit(const std::string& name, std::int64_t* values, std::size_t count) override {
    restore(name, values, count);
  }

 private:
  template <class T>
  void restore(const std::string& name, T* values, std::size_t count) {
    const std::vector<T> stored = file_.read<T>("/state/" + name);
    if (stored.size() != count) {
      throw CheckpointError(
          fmt::format("{}: {} has {} values, but the model needs {}; the checkpoint belongs to "
                      "another model",
                      file_.path(), name, stored.size(), count));
    }
    std::copy(stored.begin(), stored.end(), values);
  }
  const Hdf5File& file_;
};

void check_end(const std::string& path) {
  const std::optional<std::string> content = read_file(path);
  if (!content) throw CheckpointError(path + ": cannot be read");
  const std::string_view whole = *content;
  const std::size_t size = whole.size() < end_size ? 0 : whole.size() - end_size;
  if (size == 0 || whole.substr(size) != end_of(whole.substr(0, size))) {
    throw CheckpointError(path + ": is damaged or not a checkpoint of Zona");
  }
}

}  // namespace

void write_checkpoint(const std::string& path, const CheckpointLabels& labels,
                      const VisitState& visit) {
  Hdf5File file = Hdf5File::create_in_memory(path);
  file.create_group("/state");
  for (const auto& [name, value] : labels) file.write_attribute("/", name, value);
  StoreVisitor store(file);
  visit(store);
  std::string bytes = file.close_in_memory();
  bytes += end_of(bytes);
  replace_file(path, bytes);
}

Checkpoint::Checkpoint(const std::string& path) : path_(path) {
  check_end(path);
  try {
    const Hdf5File file = Hdf5File::open(path);
    for (const std::string& name : file.attributes("/")) {
      labels_[name] = file.read_attribute<std::string>("/", name);
    }
  } catch (const Hdf5Error& error) {
    throw CheckpointError(fmt::format("{}; the file is not a checkpoint of Zona", error.what()));
  }
}

void Checkpoint::restore(const VisitState& visit) const {
  try {
    const Hdf5File file = Hdf5File::open(path_);
    RestoreVisitor restore_visitor(file);
    visit(restore_visitor);
  } catch (const Hdf5Error& error) {
    throw CheckpointError(fmt::format("{}; the checkpoint belongs to another model", error.what()));
  }
}

}  // namespace zona::mpm
