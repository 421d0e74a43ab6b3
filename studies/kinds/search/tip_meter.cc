#include "studies/kinds/search/tip_meter.h"

#include <algorithm>
#include <cmath>

#include "beam/frequency/transfer_function.h"
#include "studies/parameters/beam_integration_table.h"
#include "studies/parameters/fill_table.h"
#include "studies/parameters/pipette_model.h"
#include "studies/parameters/pulse_table.h"

namespace zona::studies::search {

namespace {

/// Even intervals in which the window of the piercing is compared with the reference.
constexpr int window_samples = 400;

bool starts_with(const std::string& text, const char* beginning) {
  return text.rfind(beginning, 0) == 0;
}

/// The overrides that decide the transfer function.
std::string pipette_part(const Overrides& overrides) {
  std::string part;
  for (const std::string& entry : overrides)
    if (!starts_with(entry, "pulse.") && !starts_with(entry, "motion.") &&
        !starts_with(entry, "zona."))
      part += entry + "\n";
  return part;
}

/// Greatest displacement [m] and speed [m/s] of a tip, and its greatest displacement after the end
/// of a window [m].
struct TipExtremes {
  double amplitude = 0, speed = 0, residual = 0;
};

TipExtremes extremes_of(const TipHistories& tip, double window_end) {
  const std::vector<double>& times = (tip.lateral ? tip.lateral : tip.axial)->time;
  TipExtremes extremes;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto size = [&](std::vector<double> beam::TipHistory::*values) {
      return std::hypot(tip.lateral ? ((*tip.lateral).*values)[i] : 0,
                        tip.axial ? ((*tip.axial).*values)[i] : 0);
    };
    const double displacement = size(&beam::TipHistory::displacement);
    extremes.amplitude = std::max(extremes.amplitude, displacement);
    extremes.speed = std::max(extremes.speed, size(&beam::TipHistory::velocity));
    if (times[i] > window_end) extremes.residual = std::max(extremes.residual, displacement);
  }
  return extremes;
}

}  // namespace

TipMeter::TipMeter(const Plan& plan, Overrides common) : plan_(plan), common_(std::move(common)) {
  Response reference = response({});
  reference_values_ = std::move(reference.values);
  reference_values_["mismatch"] = 0;
  reference_window_ = std::move(reference.window);
}

TipHistories TipMeter::histories(const Configuration& study, const std::string& pipette) {
  const beam::Fluid fluid = fills_of(study).front();
  const auto integration = study.read<BeamIntegration>();
  if (integration.integrator != IntegratorName::transform) return beam_tip_histories(study, fluid);
  if (pipette != last_pipette_) {
    lateral_transfer_.clear();
    axial_transfer_.clear();
    last_pipette_ = pipette;
  }
  const beam::Sampling sampling = integration.sampling();
  const beam::SupportMotion pulse = support_motion(study);
  const auto history = [&](std::vector<std::complex<double>>& transfer, auto&& make_system,
                           double part) -> std::optional<beam::TipHistory> {
    if (part == 0) return std::nullopt;
    if (transfer.empty())
      transfer = beam::TransferFunction(make_system(pipette_from(study, fluid)))
                     .at(beam::transform_points(sampling));
    return beam::history_by_transform(transfer, part == 1 ? pulse : beam::scaled(pulse, part),
                                      sampling);
  };
  const PulseDirection part = study.read<Pulse>().direction();
  return {history(lateral_transfer_, beam::cantilever, part.across),
          history(axial_transfer_, beam::axial_rod, part.along)};
}

std::vector<Eigen::Vector3d> TipMeter::window_of(const coupling::TipMotion& motion) const {
  std::vector<Eigen::Vector3d> window;
  for (int i = 0; i <= window_samples; ++i) {
    const double time = std::min(window_length_ * i / window_samples, motion.length());
    window.push_back(motion(time).displacement);
  }
  return window;
}

TipMeter::Response TipMeter::response(const Overrides& overrides) {
  Overrides all = common_;
  all.insert(all.end(), overrides.begin(), overrides.end());
  const Configuration study = plan_.study(all);
  const TipHistories tip = histories(study, pipette_part(all));
  const coupling::TipMotion motion = tip_motion(study, tip);
  if (window_length_ == 0) window_length_ = motion.length();
  Response response{{}, window_of(motion)};
  double travel = 0;
  for (const Eigen::Vector3d& displacement : response.window)
    travel = std::max(travel, displacement.norm());
  const TipExtremes extremes = extremes_of(tip, motion.start() + motion.length());
  response.values = {{"tip_amplitude", extremes.amplitude},
                     {"tip_travel", travel},
                     {"peak_velocity", extremes.speed},
                     {"residual_motion", extremes.residual},
                     {"support_peak", beam::peak_displacement(support_motion(study))}};
  return response;
}

std::optional<Values> TipMeter::measure(const Overrides& overrides) {
  try {
    Response design = response(overrides);
    double difference = 0, size = 0;
    for (int i = 0; i <= window_samples; ++i) {
      difference += (design.window[i] - reference_window_[i]).squaredNorm();
      size += reference_window_[i].squaredNorm();
    }
    design.values["mismatch"] = std::sqrt(difference / size);
    return design.values;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace zona::studies::search
