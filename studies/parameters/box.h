#pragma once

#include <limits>
#include <string>
#include <vector>

#include "mpm/grid/background_grid.h"
#include "mpm/grid/region.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// Opposite corners of a box in a table [m]; an infinite coordinate is the grid's. A table with a
/// box derives from this struct.
struct BoxKeys {
  Eigen::Vector3d low{0, 0, 0};
  Eigen::Vector3d high{0, 0, 0};

  /// The box; its corners count from `origin` [m].
  mpm::Box in(const mpm::BackgroundGrid& grid,
              const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) const;
};

/// Keys of the corners, by default the whole grid.
template <class T>
void declare_box(TableKeys<T>& keys, const std::string& documentation,
                 const std::vector<Condition>& conditions = {});

/// Complains of a box whose corners are the wrong way round, or at one place unless it may be flat.
void check_box(const BoxKeys& box, bool may_be_flat, const std::string& high_key,
               const Complain& complain);

/// The same for a table that is bound to T, where its box applies.
template <class T>
void check_box(const Table& table, const Complain& complain, bool may_be_flat) {
  Eigen::Vector3d T::*low = &BoxKeys::low;
  Eigen::Vector3d T::*high = &BoxKeys::high;
  if (!table.applies(high)) return;
  check_box({table.value(low), table.value(high)}, may_be_flat, table.leaf(high), complain);
}

template <class T>
void declare_box(TableKeys<T>& keys, const std::string& documentation,
                 const std::vector<Condition>& conditions) {
  const double far = std::numeric_limits<double>::infinity();
  const auto corner = [&](const char* leaf, Eigen::Vector3d BoxKeys::*member, double end,
                          const std::string& sentences) {
    Parameter& parameter = keys.quantities(leaf, member, "m", {"grid", "grid", "grid"})
                               .exactly(3)
                               .in("[-1e6, 1e6]")
                               .or_named({{"grid", end}})
                               .doc(sentences);
    parameter.conditions.insert(parameter.conditions.end(), conditions.begin(), conditions.end());
  };
  corner("low", &BoxKeys::low, -far,
         documentation + " Lower corner; \"grid\" reaches as far as the grid does.");
  corner("high", &BoxKeys::high, far, "Upper corner of that box.");
}

}  // namespace zona::studies
