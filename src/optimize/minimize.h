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

/// Runs `algorithm` from estimates with cost `chi2`. `clock` began with optimize(). Records are appended.
/// `go_on` is asked after every iteration.
RunResult minimize(System& system, Algorithm& algorithm, const Options& options,
                   FunctionRef<bool(const IterationRecord&)> go_on, double chi2, const Stopwatch& clock,
                   std::vector<IterationRecord>& records);

}  // namespace boxplus
