#pragma once

#include <string>
#include <vector>

namespace zona::studies::verification {

enum class Verdict {
  passed,
  failed,
  reported  ///< reported without a limit
};

/// One line of the verification table.
struct Check {
  std::string quantity;   ///< with its unit: "plateau stress [MPa]"
  std::string value;      ///< as shown
  std::string reference;  ///< as shown
  std::string error;      ///< as shown; empty where there is none
  std::string limit;      ///< of the error or value; empty when only reported
  std::string origin;     ///< origin of the limit, or meaning of the value
  Verdict verdict;
};

/// |value / reference - 1| must not exceed `tolerance`.
Check near(const std::string& quantity, double value, double reference, double tolerance,
           const std::string& origin);
/// |value - reference| must not exceed `tolerance`, in the unit of the quantity.
Check within(const std::string& quantity, double value, double reference, double tolerance,
             const std::string& origin);
/// An error or defect that must not exceed `limit`.
Check at_most(const std::string& quantity, double value, double limit, const std::string& origin);
/// A value that must reach `limit`.
Check at_least(const std::string& quantity, double value, double limit, const std::string& origin);
/// The slope of log(error) over log(size), by least squares, must reach `order`.
Check converges(const std::string& quantity, const std::vector<double>& sizes,
                const std::vector<double>& errors, double order, const std::string& origin);
/// Reported beside a reference, without a verdict; `reference` may be "none".
Check reported(const std::string& quantity, double value, const std::string& reference,
               const std::string& meaning);

/// failed if any check failed, else passed.
Verdict verdict_of(const std::vector<Check>& checks);
/// "pass", "FAIL", "reported".
std::string word(Verdict verdict);

}  // namespace zona::studies::verification
