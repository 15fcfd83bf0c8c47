// SPDX-License-Identifier: BSD-3-Clause
// The outer loop of every algorithm: iterate until something says stop.
#pragma once

#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/optimize/algorithm.h"
#include "boxplus/optimize/report.h"
#include "optimize/stopwatch.h"

namespace boxplus {

struct RunResult {
  Status status = Status::kNotConverged;
  Reason reason = Reason::kMaxIterations;
  double chi2 = 0;
  int iterations = 0;
};

/// Whether somebody, or the clock, asked for the end.
constexpr bool is_interruption(Reason reason) {
  return reason == Reason::kStopFlag || reason == Reason::kTimeLimit || reason == Reason::kCallback;
}

/// Why the token is raised.
inline Reason reason_of(const StopToken& stop) {
  return stop.flag_raised() ? Reason::kStopFlag : Reason::kTimeLimit;
}

/// What a run needs besides the problem and the method.
struct RunContext {
  const Options& options;
  int max_iterations;         ///< what earlier runs left of Options::max_iterations
  double degrees_of_freedom;  ///< rows of the errors beyond the unknowns; less than 1 if there are none
  const StopToken& stop;
  const Stopwatch& clock;                           ///< began with optimize()
  FunctionRef<bool(const IterationRecord&)> go_on;  ///< asked after every iteration
  std::vector<IterationRecord>& records;            ///< appended to
};

/// Runs `algorithm` from estimates with cost `chi2`.
RunResult minimize(System& system, Algorithm& algorithm, const RunContext& context, double chi2);

}  // namespace boxplus
