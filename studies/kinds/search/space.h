#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "studies/input/configuration.h"

namespace zona::studies::search {

/// Changes of a study, as --set takes them: "pulse.duration=\"63.2 us\"".
using Overrides = std::vector<std::string>;

/// A key of a study whose value varies, within a range or over a list of values.
struct Dimension {
  std::string name;                 ///< of its table in the search
  std::string key;                  ///< "pulse.duration"
  std::vector<std::string> values;  ///< of a list, as TOML
  double low = 0, high = 0;         ///< of a range, in `unit`
  std::string unit;                 ///< as in the study file; empty for a pure number
  bool is_logarithmic = false;      ///< sampled evenly in the logarithm
  std::string source;               ///< where the range comes from

  bool is_list() const { return !values.empty(); }
  /// The value at a place from 0 to 1 in the range, in `unit`, to four digits.
  double value(double share) const;
  /// The override at a place from 0 to 1 in the range.
  std::string at(double share) const;
  /// The override with a value of the list.
  std::string choose(std::size_t number) const;
};

/// The tables of the list of T: Variable or Uncertain. Throws InputError for keys and values that
/// `base` does not have.
template <class T>
std::vector<Dimension> dimensions_from(const Configuration& search, const Configuration& base);

/// `samples` points in the unit cube of `dimensions`, one in each of `samples` layers of every
/// axis (McKay, Beckman and Conover 1979). The same for the same seed on every machine.
std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t samples,
                                                 std::uint64_t seed);

/// All combinations of the numbers of the values of the dimensions that are lists; one, empty, when
/// there is no list.
std::vector<std::vector<std::size_t>> combinations(const std::vector<Dimension>& dimensions);

/// The design of one of these combinations, at a point of the unit cube of the ranges.
Overrides overrides_at(const std::vector<Dimension>& dimensions,
                       const std::vector<std::size_t>& combination,
                       const std::vector<double>& place);

/// The value of an override as people write it: "63.2 us" of "pulse.duration=\"63.2 us\"".
std::string shown_value(const std::string& entry);
/// The key of an override: "pulse.duration".
std::string key_of(const std::string& entry);

}  // namespace zona::studies::search
