// SPDX-License-Identifier: BSD-3-Clause
#include "system/precise_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linearize/stiff_edge.h"

namespace boxplus {

void PreciseSolver::configure(const LinearizeOptions& options) {
  options_ = options;
  steps_ = 0;
}

void PreciseSolver::forget() {
  linearized_ = false;
  is_stiff_.reset();
}

bool PreciseSolver::is_stiff() {
  if (!is_stiff_) is_stiff_ = find_stiff_edge(*graph_, *plan_, options_, kStiffRatio, stop_).has_value();
  return *is_stiff_;
}

void PreciseSolver::analyze() {
  if (!analyzed_) cholesky_.analyze(plan_->structure, plan_->undetermined_blocks, stop_);
  analyzed_ = true;
}

/// The number of multiplications with 32 digits in one solve(). Infinite if the token is raised.
double PreciseSolver::multiplications() {
  try {
    analyze();
    return cholesky_.multiplications();
  } catch (const Stopped&) {
    return std::numeric_limits<double>::infinity();
  }
}

int PreciseSolver::affordable_steps() {
  constexpr double kMostMultiplications = 1e8;
  const double steps = std::floor(kMostMultiplications / std::max(multiplications(), 1.0)) - steps_;
  return static_cast<int>(std::clamp(steps, 0.0, 1e9));
}

FactorResult PreciseSolver::solve(const Damping& damping, std::span<double> step) {
  try {
    analyze();
    if (!linearized_) linearize_in_double_double(*graph_, *plan_, options_, stop_, system_);
    linearized_ = true;
  } catch (const Stopped&) {
    return {LinearStatus::kStopped};
  }
  const FactorResult factor = cholesky_.factorize(system_.values, damping, stop_);
  if (factor.status != LinearStatus::kOk) return factor;
  solution_.resize(step.size());
  std::transform(system_.gradient.begin(), system_.gradient.end(), solution_.begin(),
                 [](const DoubleDouble& entry) { return -entry; });
  cholesky_.solve(solution_);
  std::transform(solution_.begin(), solution_.end(), step.begin(),
                 [](const DoubleDouble& entry) { return static_cast<double>(entry); });
  ++steps_;
  return factor;
}

}  // namespace boxplus
