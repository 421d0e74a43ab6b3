#pragma once

#include <hdf5.h>

#include <string>

#include "mpm/files/hdf5_file.h"

/// Safe calls of HDF5's C interface, for `hdf5_file.cc` and `hdf5_attribute.cc` only.
namespace zona::mpm::hdf5 {

/// Keeps HDF5 from printing its error stack within a scope.
class QuietScope {
 public:
  QuietScope() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietScope() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  QuietScope(const QuietScope&) = delete;
  QuietScope& operator=(const QuietScope&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// HDF5's most specific description of the last failure.
inline std::string failure_reason() {
  std::string reason;
  const auto keep_first = [](unsigned level, const H5E_error2_t* error, void* text) -> herr_t {
    if (level == 0 && error->desc) *static_cast<std::string*>(text) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  return reason.empty() ? reason : " (" + reason + ")";
}

/// Owns one HDF5 handle of any kind.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Throws if an HDF5 call returned a negative number; returns the answer otherwise.
template <class Answer>
Answer check(Answer answer, const std::string& file, const std::string& object,
             const char* problem) {
  if (answer < 0) throw Hdf5Error(file, object, problem + failure_reason());
  return answer;
}

}  // namespace zona::mpm::hdf5
