// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/precise_solver.h"

#include <algorithm>

namespace boxplus {

void PreciseSolver::prepare(const Graph& graph, const Plan& plan, const LinearizeOptions& options,
                            const StopToken& stop) {
  if (!analyzed_) cholesky_.analyze(plan.structure, plan.loose_blocks, stop);
  analyzed_ = true;
  if (!linearized_) linearize_in_double_double(graph, plan, options, stop, system_);
  linearized_ = true;
}

FactorResult PreciseSolver::solve(const Graph& graph, const Plan& plan, const LinearizeOptions& options,
                                  const Damping& damping, const StopToken& stop, std::span<double> step) {
  try {
    prepare(graph, plan, options, stop);
  } catch (const Stopped&) {
    return {LinearStatus::kStopped};
  }
  const FactorResult factor = cholesky_.factorize(system_.values, damping, stop);
  if (factor.status != LinearStatus::kOk) return factor;
  solution_.resize(step.size());
  std::transform(system_.gradient.begin(), system_.gradient.end(), solution_.begin(),
                 [](const DoubleDouble& entry) { return -entry; });
  cholesky_.solve(solution_);
  std::transform(solution_.begin(), solution_.end(), step.begin(),
                 [](const DoubleDouble& entry) { return static_cast<double>(entry); });
  return factor;
}

}  // namespace boxplus
