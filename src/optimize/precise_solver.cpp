// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/precise_solver.h"

#include <algorithm>
#include <limits>

namespace boxplus {

void PreciseSolver::analyze(const Plan& plan, const StopToken& stop) {
  if (!analyzed_) cholesky_.analyze(plan.structure, plan.loose_blocks, stop);
  analyzed_ = true;
}

double PreciseSolver::multiplications(const Plan& plan, const StopToken& stop) {
  try {
    analyze(plan, stop);
    return cholesky_.multiplications();
  } catch (const Stopped&) {
    return std::numeric_limits<double>::infinity();
  }
}

FactorResult PreciseSolver::solve(const Graph& graph, const Plan& plan, const LinearizeOptions& options,
                                  const Damping& damping, const StopToken& stop, std::span<double> step) {
  try {
    analyze(plan, stop);
    if (!linearized_) linearize_in_double_double(graph, plan, options, stop, system_);
    linearized_ = true;
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
