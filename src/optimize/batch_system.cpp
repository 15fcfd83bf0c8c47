// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/batch_system.h"

#include <algorithm>
#include <utility>

#include "optimize/stopwatch.h"
#include "optimize/vector_math.h"

namespace boxplus {
namespace {

/// What GaugePolicy::kDamp adds to the diagonal, as a fraction of its largest entry: enough to lift pivots
/// that are rounding noise, too little to be seen in a step.
constexpr double kGaugeDamping = 1e-11;

/// The forcing term, at least, where the direct solver was wanted and did not fit into memory: on large maps
/// far fewer iterations than an exact step takes.
constexpr double kRoughTolerance = 0.1;

/// The forcing term, at least, of a factor in float: as good as exact for Newton's method, whose own error is
/// squared in each step, and half the refinement.
constexpr double kRefinedTolerance = 1e-6;

/// The diagonal that damping is scaled by stays above this fraction of its largest entry.
constexpr double kDiagonalFloor = 1e-12;

/// Where only solve() finds that a matrix is not positive definite, as with a factor in float: factorize(),
/// which names the block.
FactorResult find_late_failure(LinearSolver& solver, const SolveResult& solved, const BlockSystem& system,
                               const Damping& damping) {
  return solved.status == LinearStatus::kNotPositiveDefinite ? solver.factorize(system, damping)
                                                             : FactorResult();
}

}  // namespace

BatchSystem::BatchSystem(Graph& graph, const PlanRequest& request, std::shared_ptr<LinearSolver> solver,
                         SchurMode schur, AnalyzeHints hints)
    : graph_(&graph),
      plan_(std::make_unique<Plan>(make_plan(graph, request))),
      linearizer_(graph, *plan_),
      assembled_(plan_->structure, linearizer_.values()),
      solver_(std::move(solver)) {
  hints.threads = request.threads;
  if (plan_->eliminated_blocks > 0 && plan_->eliminated_blocks < plan_->structure.blocks()) {
    const bool operator_suffices = solver_->needs() == LinearSolver::Needs::kOperator;
    const bool make_values =
        schur == SchurMode::kExplicit || !(operator_suffices || schur == SchurMode::kImplicit);
    schur_ = std::make_unique<Schur>(plan_->structure, plan_->eliminated_blocks,
                                     make_values || !operator_suffices);
    if (schur_->reduced_values().empty()) {
      reduced_ = std::make_unique<ImplicitSchur>(*schur_);
    } else {
      reduced_ = std::make_unique<AssembledSystem>(schur_->reduced_structure(), schur_->reduced_values());
    }
    reduced_right_hand_side_.resize(schur_->reduced_structure().scalars());
    reduced_step_.resize(reduced_right_hand_side_.size());
    solver_->analyze(schur_->reduced_structure(), hints);
  } else {
    solver_->analyze(plan_->structure, hints);
  }
  for (auto* vector : {&diagonal_, &right_hand_side_, &product_, &damping_}) vector->resize(plan_->scalars());
}

void BatchSystem::configure(const Options& options, Timings& timings, const StopToken& stop) {
  linearize_options_ = {options.numeric_jacobians, options.triggs_correction};
  const LinearStatistics statistics = solver_->statistics();
  const double least = statistics.refused_factor_bytes > 0         ? kRoughTolerance
                       : statistics.precision == Precision::kMixed ? kRefinedTolerance
                                                                   : 0;
  control_ = {std::max(least, options.linear_tolerance), 0};
  solver_->set_stop(stop);
  timings_ = &timings;
}

double BatchSystem::chi2() {
  const TimeAdder adder(timings_->evaluate_s);
  return linearizer_.chi2();
}

bool BatchSystem::linearize() {
  const TimeAdder adder(timings_->linearize_s);
  linearizer_.linearize(linearize_options_);
  const BlockStructure& structure = plan_->structure;
  const auto values = linearizer_.values();
  for (std::uint32_t block = 0; block < structure.blocks(); ++block) {
    const double* diagonal_block = values.data() + structure.value_start[structure.column_start[block]];
    const std::uint32_t dim = structure.dim(block);
    for (std::uint32_t i = 0; i < dim; ++i)
      diagonal_[structure.offset[block] + i] = diagonal_block[i * (dim + 1)];
  }
  return all_finite(linearizer_.gradient()) && all_finite(diagonal_);
}

double BatchSystem::curvature(std::span<const double> d) {
  const TimeAdder adder(timings_->solve_s);
  assembled_.multiply(d.data(), product_.data());
  return dot(d, product_);
}

/// λD plus the gauge damping, where a component is not held in all directions.
Damping BatchSystem::full_damping(const StepDamping& damping) {
  const double largest = max_abs(diagonal_);
  const bool loose = plan_->free_components > 0 || plan_->damped_components > 0;
  const double gauge = loose ? kGaugeDamping * largest : 0;
  if (damping.scale == DampingScale::kIdentity || damping.lambda == 0)
    return {damping.lambda + gauge, nullptr};
  const double floor = std::max(kDiagonalFloor * largest, 1e-300);
  for (std::size_t i = 0; i < damping_.size(); ++i) {
    damping_[i] = damping.lambda * std::max(diagonal_[i], floor) + gauge;
  }
  return {1.0, damping_.data()};
}

StepResult BatchSystem::solve(const StepDamping& damping, std::span<double> step) {
  const auto gradient = linearizer_.gradient();
  for (std::size_t i = 0; i < gradient.size(); ++i) right_hand_side_[i] = -gradient[i];
  const Damping full = full_damping(damping);
  return schur_ ? solve_reduced(full, step) : solve_full(full, step);
}

StepResult BatchSystem::fail(const FactorResult& result, std::uint32_t first_block) {
  failed_block_ =
      result.failed_block == BlockStructure::kAbsent ? first_block : first_block + result.failed_block;
  return {result.status, 0};
}

StepResult BatchSystem::solve_full(const Damping& damping, std::span<double> step) {
  {
    const TimeAdder adder(timings_->factorize_s);
    const FactorResult factor = solver_->factorize(assembled_, damping);
    if (factor.status != LinearStatus::kOk) return fail(factor, 0);
  }
  const TimeAdder adder(timings_->solve_s);
  const SolveResult solved = solver_->solve(right_hand_side_.data(), 1, step.data(), control_);
  const FactorResult late = find_late_failure(*solver_, solved, assembled_, damping);
  if (late.status != LinearStatus::kOk) return fail(late, 0);
  const bool usable = solved.status == LinearStatus::kNotConverged;  // an inexact step is a step
  return {usable ? LinearStatus::kOk : solved.status, solved.iterations};
}

StepResult BatchSystem::solve_reduced(const Damping& damping, std::span<double> step) {
  {
    const TimeAdder adder(timings_->factorize_s);
    const FactorResult eliminated = schur_->eliminate(linearizer_.values(), damping);
    if (eliminated.status != LinearStatus::kOk) return fail(eliminated, 0);
    const FactorResult factor = solver_->factorize(*reduced_, schur_->reduced_damping(damping));
    if (factor.status != LinearStatus::kOk) return fail(factor, plan_->eliminated_blocks);
  }
  const TimeAdder adder(timings_->solve_s);
  schur_->reduce(right_hand_side_.data(), reduced_right_hand_side_.data());
  const SolveResult solved =
      solver_->solve(reduced_right_hand_side_.data(), 1, reduced_step_.data(), control_);
  const FactorResult late = find_late_failure(*solver_, solved, *reduced_, schur_->reduced_damping(damping));
  if (late.status != LinearStatus::kOk) return fail(late, plan_->eliminated_blocks);
  if (solved.status == LinearStatus::kNotFinite || solved.status == LinearStatus::kStopped) {
    return {solved.status, solved.iterations};
  }
  schur_->back_substitute(right_hand_side_.data(), reduced_step_.data(), step.data());
  return {solved.status == LinearStatus::kNotConverged ? LinearStatus::kOk : solved.status,
          solved.iterations};
}

void BatchSystem::save(int level) {
  for (const VertexList& list : plan_->vertices) graph_->vertex_pools()[list.pool]->save(list.slots, level);
}

void BatchSystem::restore(int level) {
  for (const VertexList& list : plan_->vertices)
    graph_->vertex_pools()[list.pool]->restore(list.slots, level);
}

double BatchSystem::try_step(std::span<const double> step) {
  save(VertexPool::kTrialLevel);
  try {
    for (const VertexList& list : plan_->vertices) {
      graph_->vertex_pools()[list.pool]->oplus(list.slots, list.offsets, step.data());
    }
    return chi2();
  } catch (...) {
    reject();
    throw;
  }
}

}  // namespace boxplus
