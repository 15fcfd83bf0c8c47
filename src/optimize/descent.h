// SPDX-License-Identifier: BSD-3-Clause
// The runs of one algorithm that one call of Optimizer::run() makes, one after another.
#pragma once

#include "boxplus/base/function_ref.h"
#include "boxplus/optimize/algorithm.h"
#include "boxplus/optimize/report.h"
#include "optimize/batch_system.h"
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

/// Shares the bounds of the call, on iterations and on time, between its runs.
class Descent {
 public:
  /// Everything must outlive the descent. `records` are appended to.
  Descent(Graph& graph, BatchSystem& system, Algorithm& algorithm, const Options& options,
          const StopToken& stop, const Stopwatch& clock, std::vector<IterationRecord>& records);

  Graph& graph() { return graph_; }
  BatchSystem& system() { return system_; }
  const Options& options() const { return options_; }
  const StopToken& stop() const { return stop_; }
  std::vector<IterationRecord>& records() { return records_; }

  /// Runs the algorithm from the current estimates, whose chi2 is given.
  RunResult run(double chi2);
  /// The same, but for an end with Reason::kCallback after the first iteration that `wanted` refuses.
  RunResult run_while(FunctionRef<bool(const IterationRecord&)> wanted, double chi2);

  /// Neither stopped nor out of iterations.
  bool may_go_on() const { return iterations_left() > 0 && !stop_.raised(); }
  int iterations_left() const { return options_.max_iterations - iterations_; }
  /// Of all runs together.
  int iterations() const { return iterations_; }
  int regularized_steps() const { return regularized_steps_; }
  /// Rows of the enabled active edges beyond the unknowns: the chi2 to expect if the noise is that of Ω.
  double degrees_of_freedom() const { return degrees_of_freedom_; }

 private:
  RunResult iterate(FunctionRef<bool(const IterationRecord&)> wanted, double chi2);
  bool call_back(const IterationRecord& record);

  Graph& graph_;
  BatchSystem& system_;
  Algorithm& algorithm_;
  const Options& options_;
  const StopToken& stop_;
  const Stopwatch& clock_;
  std::vector<IterationRecord>& records_;
  double degrees_of_freedom_ = 0;
  int iterations_ = 0, regularized_steps_ = 0;
};

}  // namespace boxplus
