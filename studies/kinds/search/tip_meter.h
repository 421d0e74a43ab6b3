#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "studies/kinds/piercing/case.h"
#include "studies/kinds/search/plan.h"

namespace zona::studies::search {

/// Computes the measures of the tip for designs. The reference is the base study with the overrides
/// that all designs have in common. Use one object per thread.
class TipMeter {
 public:
  TipMeter(const Plan& plan, Overrides common);

  /// Nothing where the overrides contradict each other, e.g. a bore wider than the pipette.
  std::optional<Values> measure(const Overrides& overrides);
  const Values& reference() const { return reference_values_; }

 private:
  /// Motion of the tip in the window of the piercing, and all its measures except the mismatch.
  struct Response {
    Values values;
    std::vector<Eigen::Vector3d> window;  ///< displacement at even times [m]
  };

  std::vector<Eigen::Vector3d> window_of(const coupling::TipMotion& motion) const;
  Response response(const Overrides& overrides);
  TipHistories histories(const Configuration& study, const std::string& pipette);

  const Plan& plan_;
  Overrides common_;
  double window_length_ = 0;  ///< of the reference [s]
  Values reference_values_;
  std::vector<Eigen::Vector3d> reference_window_;
  /// Transfer functions of the last pipette, across and along it, which serve all pulses; empty
  /// until they are needed.
  std::string last_pipette_;
  std::vector<std::complex<double>> lateral_transfer_, axial_transfer_;
};

}  // namespace zona::studies::search
