#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace zona::studies {

/// `zona verify`.
struct VerifyOptions {
  std::vector<std::string> cases;  ///< empty: all
  bool quick = false;
  bool list = false;           ///< only list the cases and their cost
  std::filesystem::path out;   ///< empty: runs/verification or runs/verification-quick
  std::filesystem::path page;  ///< another place for the page; empty: in `out`
  int threads = 0;             ///< of all runs together; 0: all that the machine has
  bool quiet = false;
};

/// Computes the runs of the verification cases that are not done yet, side by side, compares them
/// with their references, prints the tables and writes the page. Returns exit_ok, or
/// exit_not_verified when a check fails. Throws InputError.
int verify(const VerifyOptions& options);

}  // namespace zona::studies
