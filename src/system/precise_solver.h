// SPDX-License-Identifier: BSD-3-Clause
// Computes steps with 32 digits, for graphs whose weights span more digits than double has.
#pragma once

#include <optional>
#include <span>

#include "linear/double_double_cholesky.h"
#include "linearize/double_double_system.h"
#include "plan/plan.h"

namespace boxplus {

class PreciseSolver {
 public:
  /// `graph` and `plan` must outlive this object.
  PreciseSolver(const Graph& graph, const Plan& plan) : graph_(&graph), plan_(&plan) {}

  /// Begins a run.
  void configure(const LinearizeOptions& options);
  void set_stop(const StopToken& stop) { stop_ = stop; }
  /// Call it when the estimates change.
  void forget();

  /// Whether some edge is stiff (linearize/stiff_edge.h).
  bool is_stiff();
  /// The number of further steps that take about two seconds together with those since configure(). 0 if a
  /// single one takes longer, or if the token is raised.
  int affordable_steps();
  /// Solves (H + λD) step = −g for H and g at the estimates of the last forget().
  FactorResult solve(const Damping& damping, std::span<double> step);
  /// The number of successful calls of solve() since configure().
  int steps() const { return steps_; }

 private:
  void analyze();
  double multiplications();

  const Graph* graph_;
  const Plan* plan_;
  LinearizeOptions options_;
  StopToken stop_;
  bool analyzed_ = false, linearized_ = false;
  std::optional<bool> is_stiff_;  // at the current estimates, once it is known
  int steps_ = 0;
  DoubleDoubleSystem system_;
  DoubleDoubleCholesky cholesky_;
  std::vector<DoubleDouble> solution_;
};

}  // namespace boxplus
