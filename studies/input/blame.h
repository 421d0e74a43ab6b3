#pragma once

#include <stdexcept>
#include <string>

#include "studies/input/configuration.h"

namespace zona::studies {

/// Runs f; what it finds wrong (ModelError, TraceError, FormulaError, ...) becomes an InputError at
/// the place of the key.
template <class F>
auto blaming(const Configuration& study, const std::string& key, F f) {
  const auto refuse = [&](const std::exception& error) {
    return InputError(std::vector<Problem>{study.problem(key, error.what())});
  };
  try {
    return f();
  } catch (const InputError&) {
    throw;
  } catch (const std::logic_error& error) {  // ModelError, invalid_argument, out_of_range
    throw refuse(error);
  } catch (const std::runtime_error& error) {  // FormulaError, TraceError, FileError
    throw refuse(error);
  }
}

}  // namespace zona::studies
