#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace zona::mpm {

/// Visits all state that a computation needs to continue and that its input does not contain, each
/// array under a name of its own ("bodies/zona/strain"), to store or to restore it. Names, sizes
/// and order must be the same both times.
class StateVisitor {
 public:
  virtual ~StateVisitor() = default;

  /// True if values are restored; the caller then recomputes what depends on them.
  virtual bool is_restoring() const = 0;
  /// @{
  /// Visits `count` values: stores them, or overwrites them when restoring.
  virtual void visit(const std::string& name, double* values, std::size_t count) = 0;
  virtual void visit(const std::string& name, std::int32_t* values, std::size_t count) = 0;
  virtual void visit(const std::string& name, std::int64_t* values, std::size_t count) = 0;

  void visit(const std::string& name, double& value) { visit(name, &value, 1); }
  void visit(const std::string& name, std::int32_t& value) { visit(name, &value, 1); }
  void visit(const std::string& name, std::int64_t& value) { visit(name, &value, 1); }
  void visit(const std::string& name, Eigen::Vector3d& v) { visit(name, v.data(), 3); }
  template <class T, class Allocator>
  void visit(const std::string& name, std::vector<T, Allocator>& values) {
    visit(name, values.data(), values.size());
  }
  /// @}
};

}  // namespace zona::mpm
