// SPDX-License-Identifier: BSD-3-Clause
// Computes steps with 32 digits, for graphs whose weights span more digits than double has.
#pragma once

#include <optional>
#include <span>

#include "boxplus/linearize/plan.h"
#include "linear/double_double_cholesky.h"
#include "linearize/double_double_system.h"

namespace boxplus {

class PreciseSolver {
 public:
  /// The number of multiplications with 32 digits in one solve(). Infinite if `stop` is raised.
  double multiplications(const Plan& plan, const StopToken& stop);
  /// Solves (H + λD) step = −g for H and g at the estimates of the last forget().
  FactorResult solve(const Graph& graph, const Plan& plan, const LinearizeOptions& options,
                     const Damping& damping, const StopToken& stop, std::span<double> step);
  /// Call it when the estimates change.
  void forget() { linearized_ = false; }
  /// Call it when the plan changes. Implies forget().
  void forget_plan() { analyzed_ = linearized_ = false; }

 private:
  void analyze(const Plan& plan, const StopToken& stop);

  bool analyzed_ = false, linearized_ = false;
  DoubleDoubleSystem system_;
  DoubleDoubleCholesky cholesky_;
  std::vector<DoubleDouble> solution_;
};

}  // namespace boxplus
