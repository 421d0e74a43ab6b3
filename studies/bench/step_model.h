#pragma once

#include "mpm/step/solver.h"

namespace zona::studies::bench {

/// Bytes that a step has to move and its operations, by stage, from the fields in its code. Every
/// field crosses the memory once per stage; a field that is only written is also read, to own its
/// lines. Nodes move once per stage. A fused multiplication and addition counts as two operations.
struct StepModel {
  std::array<double, mpm::stage_count> bytes{};
  std::array<double, mpm::stage_count> flops{};

  double total_bytes() const;
  double total_flops() const;
};

StepModel step_model(const mpm::Solver& solver);

}  // namespace zona::studies::bench
