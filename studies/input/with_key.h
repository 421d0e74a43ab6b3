#pragma once

#include <stdexcept>
#include <string>

#include "studies/input/configuration.h"

namespace zona::studies {

/// Calls f and returns its result. A logic_error or runtime_error of f (ModelError, TraceError,
/// FormulaError, ...) becomes an InputError that names `key` and its place in the study file; an
/// InputError passes through.
template <class F>
auto with_key(const Configuration& study, const std::string& key, F f) {
  const auto refuse = [&](const std::exception& error) {
    return InputError(study.problem(key, error.what()));
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
