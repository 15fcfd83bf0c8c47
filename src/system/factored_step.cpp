// SPDX-License-Identifier: BSD-3-Clause
#include "system/factored_step.h"

#include <algorithm>
#include <utility>

#include "base/stopwatch.h"

namespace boxplus {

FactoredStep::FactoredStep(Model& model, std::shared_ptr<LinearSolver> solver, SchurMode schur,
                           const PlanRequest& request)
    : model_(model),
      solver_(std::move(solver), schur, KeptBlocks::kJoined),
      streamed_(model.plan, model.linearizer, solver_) {
  const Plan& plan = model.plan;
  std::vector<std::uint32_t> elimination_bounds;
  for (const Chunk& chunk : plan.chunks) elimination_bounds.push_back(chunk.first_column);
  elimination_bounds.push_back(plan.eliminated_blocks);
  solver_.analyze(plan.structure,
                  {.threads = request.threads,
                   .eliminated_blocks = plan.eliminated_blocks,
                   .last = plan.undetermined_blocks,
                   .may_be_singular = !plan.undetermined_blocks.empty(),
                   .elimination_bounds = elimination_bounds},
                  request.stop);
  solver_.leave_out(plan.fixed_scalars);
  streamed_.prepare();
}

void FactoredStep::linearize() {
  const std::optional<StepDamping> expected = std::exchange(expected_, std::nullopt);
  elimination_.reset();
  if (expected && may_eliminate_early()) return linearize_and_eliminate(*expected);
  const ScopedTimer adder(model_.timings->linearize_s);
  linearize_only();
}

/// Linearizes all edges.
void FactoredStep::linearize_only() {
  Linearizer& linearizer = model_.linearizer;
  if (model_.stores_all_columns()) {
    linearizer.linearize(model_.options);
    if (linearizer.stopped()) return;
    model_.collect(0, model_.plan.eliminated_blocks, linearizer.values().data());
  } else {
    linearizer.linearize(model_.options, solver_.slices(), [&](const Linearizer::Batch& batch) {
      model_.collect(batch.first, batch.last, batch.values);
    });
    if (linearizer.stopped()) return;
  }
  model_.collect_kept();
  model_.diagonal.find_floor();
}

/// Whether vertices can be eliminated while other edges are still being linearized. This needs columns that
/// are final when their edges have been added, except for the rows of fixed scalars, which the solver leaves
/// out of the Schur complement. Active bounds are known only when all edges have been added.
bool FactoredStep::may_eliminate_early() const {
  const Plan& plan = model_.plan;
  const std::uint32_t first_kept = plan.structure.offset[plan.eliminated_blocks];
  const auto are_kept = [&](const std::vector<std::uint32_t>& scalars) {
    return std::ranges::all_of(scalars, [&](std::uint32_t scalar) { return scalar >= first_kept; });
  };
  return streamed_.is_possible() && model_.bounds.empty() && are_kept(plan.fixed_scalars) &&
         are_kept(plan.held_scalars) && are_kept(model_.gauge.current().lost_scalars);
}

/// Linearizes all edges, and eliminates each batch of vertices. The floor of the diagonal is known only at
/// the end. Until then, assumes that it is the floor of the previous linearization. If the floor turns out to
/// be another one, and the eliminated columns depend on it, the elimination is not used.
void FactoredStep::linearize_and_eliminate(const StepDamping& damping) {
  StepDiagonal& diagonal = model_.diagonal;
  const std::vector<std::uint32_t>& offset = model_.plan.structure.offset;
  const bool uniform = model_.is_uniform(damping);
  const Damping full = uniform ? Damping{damping.lambda, nullptr} : Damping{1.0, diagonal.added()};
  const double assumed = diagonal.floor(), gauge = model_.gauge.fraction();
  const auto collect_batch = [&](const Linearizer::Batch& batch) {
    model_.collect(batch.first, batch.last, batch.values);
    if (!uniform) diagonal.fill(damping, gauge, assumed, offset[batch.first], offset[batch.last]);
  };
  streamed_.run(full, model_.control_with_right_hand_side(), model_.options, *model_.timings, collect_batch);
  if (model_.linearizer.stopped()) return;
  model_.collect_kept();
  diagonal.find_floor();
  if (!uniform) {
    const std::uint32_t eliminated = offset[model_.plan.eliminated_blocks];
    if (diagonal.depends_on_floor(damping, gauge, assumed, diagonal.floor(), eliminated)) return;
    diagonal.fill(damping, gauge, diagonal.floor(), eliminated, model_.plan.scalars());
    model_.hold_scalars(damping);
  }
  elimination_ = {damping, full};
}

StepResult FactoredStep::failed(LinearStatus status, std::uint32_t block, std::uint32_t scalar) {
  const Plan& plan = model_.plan;
  const bool reduces = plan.eliminated_blocks < plan.structure.blocks();
  const std::uint32_t likely = reduces ? plan.eliminated_blocks : 0;
  failed_block_ = block == BlockStructure::kAbsent ? likely : block;
  failed_scalar_ = scalar;
  return {status};
}

FactorResult FactoredStep::factorize(const StepDamping& damping) {
  const SolveControl control = model_.control_with_right_hand_side();
  const std::optional<Elimination> elimination = std::exchange(elimination_, std::nullopt);
  if (elimination && elimination->damping == damping) {
    const ScopedTimer adder(model_.timings->factorize_s);
    const FactorResult result = streamed_.finish(elimination->full, control);
    if (result.status == LinearStatus::kOk || result.status == LinearStatus::kStopped) return result;
  }
  const Damping full = model_.full_damping(damping);
  if (!model_.stores_all_columns()) {
    streamed_.run(full, control, model_.options, *model_.timings, [](const Linearizer::Batch&) {});
    if (model_.linearizer.stopped()) return {LinearStatus::kStopped};
  }
  const ScopedTimer adder(model_.timings->factorize_s);
  return model_.stores_all_columns() ? solver_.factorize(model_.assembled, full, control)
                                     : streamed_.finish(full, control);
}

/// Computes the step from the factor.
SolveResult FactoredStep::solve_factorized(std::span<double> step) {
  const ScopedTimer adder(model_.timings->solve_s);
  if (model_.stores_all_columns())
    return solver_.solve(model_.right_hand_side.data(), 1, step.data(), model_.control);
  return streamed_.solve(model_.control_with_right_hand_side(), model_.options, step);
}

StepResult FactoredStep::solve(const StepDamping& damping, std::span<double> step) {
  has_factor_ = false;
  const FactorResult factor = factorize(damping);
  if (factor.status != LinearStatus::kOk)
    return failed(factor.status, factor.failed_block, factor.failed_scalar);
  const SolveResult solved = solve_factorized(step);
  if (solved.status == LinearStatus::kNotPositiveDefinite)
    return failed(solved.status, solved.failed_block, solved.failed_scalar);
  has_factor_ = solved.status == LinearStatus::kOk && solved.exact;
  const bool usable = solved.status == LinearStatus::kNotConverged;  // an inexact step is usable
  return {usable ? LinearStatus::kOk : solved.status, solved.iterations, solved.exact};
}

bool FactoredStep::apply_inverse(const double* b, double* x) {
  return solver_.solve(b, 1, x, model_.control).status == LinearStatus::kOk;
}

}  // namespace boxplus
