// SPDX-License-Identifier: BSD-3-Clause
#include "system/forcing_term.h"

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

double forcing_term(const Options& options, const Plan& plan) {
  constexpr double kRough = 0.01;
  if (options.linear_tolerance > 0) return options.linear_tolerance;
  const bool is_pcg = options.linear_solver == LinearSolverKind::kPcg && !options.custom_linear_solver;
  const bool eliminates = plan.eliminated_blocks > 0 && plan.eliminated_blocks < plan.structure.blocks();
  return is_pcg && eliminates ? kRough : SolveControl().relative_tolerance;
}

}  // namespace boxplus
