#pragma once

#include <functional>
#include <string>

#include "studies/input/configuration.h"
#include "studies/run/session.h"

namespace zona::studies {

/// Computes a study, writes its files into the session's run directory and its results into
/// `session.results`. Polls Interrupt::requested() and then returns early, with what it has.
/// Throws RunError when the computation cannot go on.
using Job = std::function<void(Session&)>;

/// Checks what the schema of a study cannot check, before a file is written; throws InputError.
/// Returns the job to be done.
using Prepare = std::function<Job(const Configuration&)>;

/// Cost of a study, estimated without computing it.
struct StudyCost {
  std::string text;        ///< points, steps, time, in a few lines
  double point_steps = 0;  ///< points times steps; 0 where that means nothing
};
using CostEstimate = std::function<StudyCost(const Configuration&)>;

/// Text about time and memory on this machine with so many threads, from computing a little of the
/// study.
using TryHere = std::function<std::string(const Configuration&, int threads)>;

/// A value of `study = "..."`.
struct StudyKind {
  const Schema* schema;  ///< its name, summary and keys; lives as long as the program
  Prepare prepare;
  CostEstimate estimate;  ///< empty when there is none
  TryHere try_here;       ///< empty where a run takes seconds at most
};

}  // namespace zona::studies
