#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace zona::studies {

/// One error in the input of the user.
struct Problem {
  std::string where;    ///< "file:line", "file" or "--set"
  std::string key;      ///< dotted key, empty when the problem is not about one
  std::string message;  ///< what is wrong; what is allowed; what to do
  int line = 0;         ///< line in the file, 0 for overrides and for the file as a whole

  /// "where: key: message", fit for a terminal.
  std::string text() const;
};

/// The input cannot be used. Carries every problem found, in the order of the file, so that a user
/// repairs a study file in one go. The program then exits with code 2 and writes nothing.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems);
  explicit InputError(Problem problem);
  /// One problem that belongs to no key, e.g. an output directory that is in use.
  InputError(std::string where, std::string message);

  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// A run of a valid study failed (a point left the grid, a disk is full). The program exits with
/// code 3 and keeps what was written.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `text` made safe and short for a message: control characters escaped, at most `length` bytes
/// with an ellipsis for the rest.
std::string printable(std::string_view text, std::size_t length = 60);

}  // namespace zona::studies
