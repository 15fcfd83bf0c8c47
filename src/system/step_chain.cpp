// SPDX-License-Identifier: BSD-3-Clause
#include "system/step_chain.h"

#include <algorithm>
#include <utility>

#include "base/stopwatch.h"
#include "base/vector_math.h"

namespace boxplus {

void ExactStep::begin_run() {
  is_precise_ = false;
  precise_.configure(model_.options);
}

StepResult ExactStep::solve(const StepDamping& damping, std::span<double> step) {
  StepResult result = {LinearStatus::kNotPositiveDefinite};
  next_.forget_factor();
  if (!is_precise_) result = next_.solve(damping, step);
  const bool is_lost = result.status == LinearStatus::kNotPositiveDefinite;
  if (is_precise_ || (is_lost && precise_.is_stiff() && precise_.affordable_steps() > 0))
    result = solve_precisely(damping, step);
  for (const std::uint32_t i : model_.plan.fixed_scalars) step[i] = 0;  // even with a custom solver
  model_.bounds.hold(step);
  return result;
}

StepResult ExactStep::solve_precisely(const StepDamping& damping, std::span<double> step) {
  const ScopedTimer adder(model_.timings->solve_s);
  const FactorResult factor = precise_.solve(model_.full_damping(damping), step);
  if (factor.status != LinearStatus::kOk)
    return next_.failed(factor.status, factor.failed_block, factor.failed_scalar);
  return {.exact = true};
}

StepResult GaugeFreeStep::solve(const StepDamping& damping, std::span<double> step) {
  GaugeRemoval& gauge = model_.gauge;
  const StepResult result = gauge.solve(
      {.once = [&] { return next_.solve(damping, step); },
       .lost_pivot = [&] { return std::pair(factored_.failed_block(), factored_.failed_scalar()); },
       .held_are_free = [&] { return held_are_free(damping, step); }});
  if (result.status != LinearStatus::kOk) return result;
  gauge.for_each_held(damping.lambda, [&](std::uint32_t i) { step[i] = 0; });
  if (!factored_.has_factor() || model_.plan.eliminated_blocks > 0) return result;
  const ScopedTimer adder(model_.timings->solve_s);
  const auto apply_inverse = [&](const double* b, double* x) { return factored_.apply_inverse(b, x); };
  gauge.shorten(model_.diagonal_of_hessian(), damping.lambda, apply_inverse, step);
  return result;
}

/// Whether the held directions are still gauge freedom. The gradient vanishes along every free direction. So
/// if the step along held directions is larger than a rounding error, the edges measure these directions now.
/// This happens if the plan was made when poses coincided or were on a line, because more directions are free
/// at such estimates.
bool GaugeFreeStep::held_are_free(const StepDamping& damping, std::span<const double> step) const {
  constexpr double kOfDecrease = 1e-9, kOfChi2 = 1e-11, kExact = 1e-20;
  const std::span<const double> diagonal = model_.diagonal_of_hessian();
  double along = 0;  // the decrease of chi2 along held directions
  model_.gauge.for_each_held(damping.lambda,
                             [&](std::uint32_t i) { along += diagonal[i] * step[i] * step[i]; });
  return along <= std::max(kOfDecrease * dot(model_.right_hand_side, step), kOfChi2 * model_.chi2) + kExact;
}

/// Solves for the steps of the others while blocked entries go to their limits.
StepResult BoundedStep::solve_with_blocked(const StepDamping& damping, std::span<double> step) {
  std::vector<double>& right_hand_side = model_.right_hand_side;
  const std::vector<double>& gradient = model_.gradient;
  model_.bounds.for_each_blocked([&](std::uint32_t i, double distance) {
    right_hand_side[i] = model_.stiffness(i) * distance - gradient[i];
  });
  const StepResult result = next_.solve(damping, step);
  model_.bounds.for_each_blocked([&](std::uint32_t i, double) { right_hand_side[i] = -gradient[i]; });
  return result;
}

StepResult BoundedStep::solve(const StepDamping& damping, std::span<double> step) {
  constexpr int kRounds = 50;
  Bounds& bounds = model_.bounds;
  const std::span<const double> diagonal = model_.diagonal_of_hessian();
  changes_bounds_ = false;
  if (bounds.empty()) return next_.solve(damping, step);
  bounds.begin_step([&](std::uint32_t i) {
    const bool is_uniform = damping.scale == Options::DampingScale::kIdentity;
    return diagonal[i] + damping.lambda * (is_uniform ? 1 : model_.diagonal.scale()[i]);
  });
  StepResult result = solve_with_blocked(damping, step);
  for (int round = 0; round < kRounds; ++round) {
    if (result.status != LinearStatus::kOk || !bounds.revise(step)) break;
    result = solve_with_blocked(damping, step);
  }
  if (result.status != LinearStatus::kOk) return result;
  const auto decrease = [&](std::span<const double> d) {
    return model_decrease(model_.gradient, d, model_.curvature(d));
  };
  const bool changes = bounds.keep_within(step, decrease);
  if (changes && !(decrease(step) > 0) && bounds.stop_blocked()) {
    result = solve_with_blocked(damping, step);
    if (result.status != LinearStatus::kOk) return result;
    bounds.keep_within(step, decrease);
  }
  if (changes) result.exact = false;
  changes_bounds_ = changes || bounds.frees_active([&](std::uint32_t i) { return model_.stiffness(i); },
                                                   diagonal, kRounding * model_.chi2);
  return result;
}

}  // namespace boxplus
