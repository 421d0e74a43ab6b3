#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace zona::mpm {

/// Is shown everything that the future of a computation depends on and that its input does not
/// tell, each under a name of its own ("bodies/zona/strain"), to store it or to give it the value
/// that was stored. What is visited has the same size and order both times.
class StateVisitor {
 public:
  virtual ~StateVisitor() = default;

  /// Whether values are given back; what follows from them is then to be found anew.
  virtual bool is_restoring() const = 0;
  /// @{
  /// Shows `count` values: reads them, or writes them when restoring.
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
