#pragma once

#include "mpm/step/solver.h"

namespace zona::studies::bench {

/// What a step has to move and to compute, by stage, from the fields that its code names: every
/// field crosses the memory once a stage, and one that is only written is read to own its lines.
/// Nodes are moved once a stage. Operations count a fused multiplication and addition as two.
struct StepModel {
  std::array<double, mpm::stage_count> bytes{};
  std::array<double, mpm::stage_count> flops{};

  double total_bytes() const;
  double total_flops() const;
};

StepModel step_model(const mpm::Solver& solver);

}  // namespace zona::studies::bench
