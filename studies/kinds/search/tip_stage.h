#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "studies/kinds/piercing/case.h"
#include "studies/kinds/search/plan.h"
#include "studies/run/session.h"

namespace zona::studies::search {

/// The tip's measures of designs; the reference is the base with the settings common to all. One
/// object per thread.
class TipMeter {
 public:
  TipMeter(const Plan& plan, Settings common);

  /// Nothing where the settings contradict each other, e.g. a bore wider than the pipette.
  std::optional<Values> measure(const Settings& settings);
  const Values& reference() const { return reference_values_; }

 private:
  /// What the tip does in the window of the piercing, and its measures but the mismatch.
  struct Response {
    Values values;
    std::vector<Eigen::Vector3d> window;  ///< displacement at even times [m]
  };

  Response response(const Settings& settings);
  TipHistories histories(const Configuration& study, const std::string& pipette);

  const Plan& plan_;
  Settings common_;
  double window_length_ = 0;  ///< of the reference [s]
  Values reference_values_;
  std::vector<Eigen::Vector3d> reference_window_;
  /// The last pipette's transfer functions, across and along it, serve all pulses; empty where they
  /// have not been needed.
  std::string last_pipette_;
  std::vector<std::complex<double>> lateral_transfer_, axial_transfer_;
};

/// One design and what its tip does.
struct Design {
  std::size_t combination = 0;  ///< of listed values
  std::vector<double> place;    ///< in the unit cube of the ranges
  Settings settings;
  Values tip;
};

/// What the beams came to.
struct TipStage {
  Values reference;
  std::vector<Design> designs;  ///< all that were tried and were possible, by combination
  std::size_t impossible = 0;   ///< settings that contradict each other
};

/// Hypercube, then optimiser, in every combination; in parallel. The same for any number of
/// threads; after an interrupt, what there is.
TipStage explore(const Plan& plan, Session& session);

/// The designs that go on: of each combination as many, from the Pareto front of the tip's
/// objectives among those within its limits, spread out. Numbers of designs.
std::vector<std::size_t> choose_candidates(const Plan& plan, const TipStage& stage);

}  // namespace zona::studies::search
