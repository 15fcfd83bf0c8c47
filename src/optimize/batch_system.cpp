// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/batch_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "optimize/forcing_term.h"
#include "optimize/stopwatch.h"
#include "optimize/vector_math.h"

namespace boxplus {
namespace {

/// The request. Asks to store all columns if the solver needs an operator instead of a Schur complement.
PlanRequest with_columns(PlanRequest request, const LinearSolver& solver, SchurMode schur) {
  if (schur != SchurMode::kExplicit && solver.needs() != LinearSolver::Needs::kBlocks)
    request.columns = ColumnStorage::kAll;
  return request;
}

/// Entries that bounds hold get this multiple of their diagonal entries of H.
constexpr double kOfBounds = 1e8;

}  // namespace

BatchSystem::BatchSystem(Graph& graph, const PlanRequest& request, std::shared_ptr<LinearSolver> solver,
                         SchurMode schur)
    : graph_(&graph),
      plan_(std::make_unique<Plan>(make_plan(graph, with_columns(request, *solver, schur)))),
      before_step_(graph, *plan_),  // so that no iteration allocates, not even the first
      linearizer_(graph, *plan_),
      assembled_(plan_->structure, linearizer_.values()),
      solver_(std::move(solver), schur, KeptBlocks::kJoined),
      streamed_(*plan_, linearizer_, solver_),
      gauge_(graph, *plan_, request.gauge),
      precise_(graph, *plan_) {
  threads_ = request.threads;
  for (const Chunk& chunk : plan_->chunks) elimination_bounds_.push_back(chunk.first_column);
  elimination_bounds_.push_back(plan_->eliminated_blocks);
  solver_.analyze(plan_->structure, hints(), request.stop);
  solver_.leave_out(plan_->fixed_scalars);
  streamed_.prepare();
  resize_vectors();
}

AnalyzeHints BatchSystem::hints() const {
  return {.threads = threads_,
          .eliminated_blocks = plan_->eliminated_blocks,
          .last = plan_->undetermined_blocks,
          .may_be_singular = !plan_->undetermined_blocks.empty(),
          .elimination_bounds = elimination_bounds_};
}

void BatchSystem::resize_vectors() {
  for (auto* vector : {&gradient_, &right_hand_side_}) vector->resize(plan_->scalars());
  diagonal_.resize(plan_->scalars());
  if (stores_all_columns() || !plan_->fixed_scalars.empty()) product_.resize(plan_->scalars());
}

bool BatchSystem::extend(const PlanRequest& request, const PlannedElements& planned) {
  if (!extensible_) extensible_ = is_extensible(*graph_, *plan_);
  if (!*extensible_) return false;
  const auto growth = extend_plan(*graph_, request, planned, *plan_);
  if (!growth) return false;
  order_.forget();
  precise_.forget_plan();
  linearizer_.extend();
  assembled_ = AssembledSystem(plan_->structure, linearizer_.values());
  resize_vectors();
  if (!solver_.extend(growth->of_structure(), request.stop))
    solver_.analyze(plan_->structure, hints(), request.stop);
  return true;
}

void BatchSystem::configure(const Options& options, Report::Timings& timings, const StopToken& stop) {
  linearize_options_ = {options.numeric_jacobians, options.triggs_correction};
  control_ = {.relative_tolerance = forcing_term(options, *plan_)};
  order_.forget();
  last_chi2_ = 0;
  is_precise_ = false;
  precise_.configure(linearize_options_);
  expected_.reset();
  set_stop(stop);
  timings_ = &timings;
  diagonal_.begin_run();
  move_within_bounds(*graph_, options.vertices);
  bounds_.read(*graph_, *plan_);
  gauge_.begin_run(!bounds_.empty());
}

void BatchSystem::set_stop(const StopToken& stop) {
  control_.stop = stop;
  precise_.set_stop(stop);
  linearizer_.set_stop(stop);
}

double BatchSystem::chi2() {
  const ScopedTimer adder(timings_->evaluate_s);
  last_chi2_ = linearizer_.chi2();
  stopped_ = linearizer_.stopped();
  return last_chi2_;
}

bool BatchSystem::linearize() {
  order_.expect_no_trial("System::linearize");
  order_.forget();  // until this function ends without an exception
  gauge_.begin_linearization();
  model_chi2_ = last_chi2_;
  precise_.forget();
  const std::optional<StepDamping> expected = std::exchange(expected_, std::nullopt);
  elimination_.reset();
  if (expected && may_eliminate_early()) {
    linearize_and_eliminate(*expected);
  } else {
    const ScopedTimer adder(timings_->linearize_s);
    linearize_only();
  }
  order_.linearized();
  stopped_ = linearizer_.stopped();
  is_complete_ = !stopped_;
  if (is_complete_) bounds_.find_active(*graph_, gradient_, right_hand_side_);
  return is_complete_ && all_finite(gradient_) && all_finite(diagonal());
}

/// Sets the gradient, the diagonal of H, the scale and the right-hand side for the blocks [first, last),
/// whose columns begin with `values`.
void BatchSystem::collect(std::uint32_t first, std::uint32_t last, const double* values) {
  const BlockStructure& structure = plan_->structure;
  const double* gradient = linearizer_.gradient().data();
  for (std::uint32_t block = first; block < last; ++block) {
    const std::uint32_t dim = structure.dim(block), offset = structure.offset[block];
    for (std::uint32_t i = 0; i < dim; ++i) {
      diagonal_.set(offset + i, values[i * (dim + 1)]);
      gradient_[offset + i] = gradient[offset + i];
      right_hand_side_[offset + i] = -gradient[offset + i];
    }
    values += plan_->first_value(block + 1) - plan_->first_value(block);
  }
}

/// Linearizes all edges.
void BatchSystem::linearize_only() {
  if (stores_all_columns()) {
    linearizer_.linearize(linearize_options_);
    if (linearizer_.stopped()) return;
    collect(0, plan_->structure.blocks(), linearizer_.values().data());
  } else {
    linearizer_.linearize(linearize_options_, solver_.slices(), [&](const Linearizer::Batch& batch) {
      collect(batch.first, batch.last, batch.values);
    });
    if (linearizer_.stopped()) return;
    collect_kept();
  }
  diagonal_.find_floor();
}

void BatchSystem::collect_kept() {
  const auto kept = linearizer_.values().last(plan_->shared_values());
  collect(plan_->eliminated_blocks, plan_->structure.blocks(), kept.data());
}

/// Whether vertices can be eliminated while other edges are still being linearized. This needs columns that
/// are final when their edges have been added, except for the rows of fixed scalars, which the solver leaves
/// out of the Schur complement. Active bounds are known only when all edges have been added.
bool BatchSystem::may_eliminate_early() const {
  const std::uint32_t first_kept = plan_->structure.offset[plan_->eliminated_blocks];
  const auto are_kept = [&](const std::vector<std::uint32_t>& scalars) {
    return std::ranges::all_of(scalars, [&](std::uint32_t scalar) { return scalar >= first_kept; });
  };
  return streamed_.is_possible() && bounds_.empty() && are_kept(plan_->fixed_scalars) &&
         are_kept(plan_->held_scalars) && are_kept(gauge_.current().lost_scalars);
}

/// Linearizes all edges, and eliminates each batch of vertices. The floor of the diagonal is known only at
/// the end. Until then, assumes that it is the floor of the previous linearization. If the floor turns out to
/// be another one, and the eliminated columns depend on it, the elimination is not used.
void BatchSystem::linearize_and_eliminate(const StepDamping& damping) {
  const std::vector<std::uint32_t>& offset = plan_->structure.offset;
  const bool uniform = is_uniform(damping);
  const Damping full = uniform ? Damping{damping.lambda, nullptr} : Damping{1.0, diagonal_.added()};
  const double assumed = diagonal_.floor(), gauge = gauge_.fraction();
  const auto collect_batch = [&](const Linearizer::Batch& batch) {
    collect(batch.first, batch.last, batch.values);
    if (!uniform) diagonal_.fill(damping, gauge, assumed, offset[batch.first], offset[batch.last]);
  };
  streamed_.run(full, control_with_right_hand_side(), linearize_options_, *timings_, collect_batch);
  if (linearizer_.stopped()) return;
  collect_kept();
  diagonal_.find_floor();
  if (!uniform) {
    const std::uint32_t eliminated = offset[plan_->eliminated_blocks];
    if (diagonal_.depends_on_floor(damping, gauge, assumed, diagonal_.floor(), eliminated)) return;
    diagonal_.fill(damping, gauge, diagonal_.floor(), eliminated, plan_->scalars());
    hold_scalars(damping);
  }
  elimination_ = {damping, full};
}

SolveControl BatchSystem::control_with_right_hand_side() const {
  SolveControl control = control_;
  control.right_hand_side = right_hand_side_.data();
  return control;
}

double BatchSystem::curvature(std::span<const double> d) {
  order_.expect_vector("System::curvature", d.size(), plan_->scalars());
  if (!is_complete_) return std::numeric_limits<double>::quiet_NaN();
  const ScopedTimer adder(timings_->solve_s);
  if (stores_all_columns()) {
    assembled_.multiply(d.data(), product_.data());
    return dot(d, product_);
  }
  if (plan_->fixed_scalars.empty()) return linearizer_.curvature(linearize_options_, d.data());
  std::copy(d.begin(), d.end(), product_.begin());
  double along_fixed = 0;  // H has only a diagonal there
  for (const std::uint32_t i : plan_->fixed_scalars) {
    along_fixed += diagonal()[i] * d[i] * d[i];
    product_[i] = 0;
  }
  return along_fixed + linearizer_.curvature(linearize_options_, product_.data());
}

/// Whether the matrix to add to H is λI.
bool BatchSystem::is_uniform(const StepDamping& damping) const {
  return StepDiagonal::is_uniform(damping) && gauge_.fraction() == 0 && !bounds_.holds_any() &&
         !gauge_.holds_any(damping.lambda);
}

/// Adds the diagonal entry of H for each held scalar, and much more for entries that bounds hold: these are
/// no gauge freedom, so the others must not move because of them.
void BatchSystem::hold_scalars(const StepDamping& damping) {
  gauge_.for_each_held(damping.lambda, [&](std::uint32_t i) { diagonal_.hold(i, 1); });
  bounds_.for_each_held([&](std::uint32_t i) { diagonal_.hold(i, kOfBounds); });
}

/// The diagonal matrix to add to H.
Damping BatchSystem::full_damping(const StepDamping& damping) {
  if (is_uniform(damping)) return {damping.lambda, nullptr};
  diagonal_.fill(damping, gauge_.fraction(), diagonal_.floor(), 0, plan_->scalars());
  hold_scalars(damping);
  return {1.0, diagonal_.added()};
}

StepResult BatchSystem::solve(const StepDamping& damping, std::span<double> step) {
  order_.expect_vector("System::solve", step.size(), plan_->scalars());
  if (!is_complete_) return {LinearStatus::kStopped};
  gauge_.begin_solve();
  const StepResult result = solve_within_bounds(damping, step);
  gauge_.end_solve();
  return result;
}

/// What is added to the diagonal entry of H of an entry that bounds hold.
double BatchSystem::stiffness(std::uint32_t scalar) const {
  return kOfBounds * std::max(diagonal()[scalar], diagonal_.floor());
}

/// Solves for the steps of the others while blocked entries go to their limits.
StepResult BatchSystem::solve_with_blocked(const StepDamping& damping, std::span<double> step) {
  bounds_.for_each_blocked([&](std::uint32_t i, double distance) {
    right_hand_side_[i] = stiffness(i) * distance - gradient_[i];
  });
  const StepResult result = solve_without_gauge(damping, step);
  bounds_.for_each_blocked([&](std::uint32_t i, double) { right_hand_side_[i] = -gradient_[i]; });
  return result;
}

/// Solves. If limits block the step, solves again without the entries that do so.
StepResult BatchSystem::solve_within_bounds(const StepDamping& damping, std::span<double> step) {
  constexpr int kRounds = 50;
  changes_bounds_ = false;
  if (bounds_.empty()) return solve_without_gauge(damping, step);
  bounds_.begin_step([&](std::uint32_t i) {
    const bool is_uniform = damping.scale == Options::DampingScale::kIdentity;
    return diagonal()[i] + damping.lambda * (is_uniform ? 1 : diagonal_.scale()[i]);
  });
  StepResult result = solve_with_blocked(damping, step);
  for (int round = 0; round < kRounds; ++round) {
    if (result.status != LinearStatus::kOk || !bounds_.revise(step)) break;
    result = solve_with_blocked(damping, step);
  }
  if (result.status != LinearStatus::kOk) return result;
  const auto decrease = [&](std::span<const double> d) { return model_decrease(gradient_, d, curvature(d)); };
  const bool changes = bounds_.keep_within(step, decrease);
  if (changes && !(decrease(step) > 0) && bounds_.stop_blocked()) {
    result = solve_with_blocked(damping, step);
    if (result.status != LinearStatus::kOk) return result;
    bounds_.keep_within(step, decrease);
  }
  if (changes) result.exact = false;
  changes_bounds_ = changes || bounds_.frees_active([&](std::uint32_t i) { return stiffness(i); }, diagonal(),
                                                    kRounding * model_chi2_);
  return result;
}

StepResult BatchSystem::solve_without_gauge(const StepDamping& damping, std::span<double> step) {
  const StepResult result =
      gauge_.solve({.once = [&] { return solve_once(damping, step); },
                    .lost_pivot = [&] { return std::pair(failed_block_, failed_scalar_); },
                    .held_are_free = [&] { return held_are_free(damping, step); }});
  if (result.status != LinearStatus::kOk) return result;
  gauge_.for_each_held(damping.lambda, [&](std::uint32_t i) { step[i] = 0; });
  if (!has_factor_ || plan_->eliminated_blocks > 0) return result;
  const ScopedTimer adder(timings_->solve_s);
  const auto apply_inverse = [&](const double* b, double* x) {
    return solver_.solve(b, 1, x, control_).status == LinearStatus::kOk;
  };
  gauge_.shorten(diagonal(), damping.lambda, apply_inverse, step);
  return result;
}

StepResult BatchSystem::solve_once(const StepDamping& damping, std::span<double> step) {
  StepResult result = {LinearStatus::kNotPositiveDefinite};
  has_factor_ = false;
  if (!is_precise_) result = factorize_and_solve(damping, step);
  const bool is_lost = result.status == LinearStatus::kNotPositiveDefinite;
  if (is_precise_ || (is_lost && precise_.is_stiff() && precise_.affordable_steps() > 0))
    result = solve_precisely(damping, step);
  for (const std::uint32_t i : plan_->fixed_scalars) step[i] = 0;  // exactly 0, even with a custom solver
  bounds_.hold(step);
  return result;
}

StepResult BatchSystem::solve_precisely(const StepDamping& damping, std::span<double> step) {
  const ScopedTimer adder(timings_->solve_s);
  const FactorResult factor = precise_.solve(full_damping(damping), step);
  if (factor.status != LinearStatus::kOk)
    return failed(factor.status, factor.failed_block, factor.failed_scalar);
  return {.exact = true};
}

/// Whether the held directions are still gauge freedom. The gradient vanishes along every free direction. So
/// if the step along held directions is larger than a rounding error, the edges measure these directions now.
/// This happens if the plan was made when poses coincided or were on a line, because more directions are free
/// at such estimates.
bool BatchSystem::held_are_free(const StepDamping& damping, std::span<const double> step) const {
  constexpr double kOfDecrease = 1e-9, kOfChi2 = 1e-11, kExact = 1e-20;
  double along = 0;  // the decrease of chi2 along held directions
  gauge_.for_each_held(damping.lambda, [&](std::uint32_t i) { along += diagonal()[i] * step[i] * step[i]; });
  return along <= std::max(kOfDecrease * dot(right_hand_side_, step), kOfChi2 * model_chi2_) + kExact;
}

bool BatchSystem::is_free() {
  if (!plan_->freedoms.empty()) return true;
  if ((plan_->undetermined_blocks.empty() && !gauge_.has_other_types()) || !linearize()) return false;
  std::vector<double> step(plan_->scalars());
  return solve({}, step).status == LinearStatus::kNotPositiveDefinite;
}

/// Records the block that was not positive definite. If the solver does not name it, assumes the first block
/// that the Schur complement does not eliminate.
StepResult BatchSystem::failed(LinearStatus status, std::uint32_t block, std::uint32_t scalar) {
  const bool reduces = plan_->eliminated_blocks < plan_->structure.blocks();
  const std::uint32_t likely = reduces ? plan_->eliminated_blocks : 0;
  failed_block_ = block == BlockStructure::kAbsent ? likely : block;
  failed_scalar_ = scalar;
  return {status};
}

FactorResult BatchSystem::factorize(const StepDamping& damping) {
  const SolveControl control = control_with_right_hand_side();
  const std::optional<Elimination> elimination = std::exchange(elimination_, std::nullopt);
  if (elimination && elimination->damping == damping) {
    const ScopedTimer adder(timings_->factorize_s);
    const FactorResult result = streamed_.finish(elimination->full, control);
    if (result.status == LinearStatus::kOk || result.status == LinearStatus::kStopped) return result;
  }
  const Damping full = full_damping(damping);
  if (!stores_all_columns()) {
    streamed_.run(full, control, linearize_options_, *timings_, [](const Linearizer::Batch&) {});
    if (linearizer_.stopped()) return {LinearStatus::kStopped};
  }
  const ScopedTimer adder(timings_->factorize_s);
  return stores_all_columns() ? solver_.factorize(assembled_, full, control)
                              : streamed_.finish(full, control);
}

/// Computes the step from the factor.
SolveResult BatchSystem::solve_factorized(std::span<double> step) {
  const ScopedTimer adder(timings_->solve_s);
  if (stores_all_columns()) return solver_.solve(right_hand_side_.data(), 1, step.data(), control_);
  return streamed_.solve(control_with_right_hand_side(), linearize_options_, step);
}

StepResult BatchSystem::factorize_and_solve(const StepDamping& damping, std::span<double> step) {
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

double BatchSystem::try_step(std::span<const double> step) {
  order_.expect_vector("System::try_step", step.size(), plan_->scalars());
  if (!bounds_.empty()) step = bounds_.clipped(step);
  double largest = 0;
  for (std::size_t i = 0; i < step.size(); ++i)
    largest = std::max(largest, diagonal()[i] * step[i] * step[i]);
  step_in_deviations_ = std::sqrt(largest);
  before_step_.take(*graph_, *plan_);
  order_.moved();
  try {
    for (const VertexList& list : plan_->vertices)
      graph_->vertex_pools()[list.pool]->oplus(list.slots, list.offsets, step.data());
    bounds_.arrive(*graph_, step);
    trial_ = {chi2(), max_abs(step)};
    return trial_.chi2;
  } catch (...) {
    take_back_step();
    throw;
  }
}

void BatchSystem::accept() {
  order_.expect_trial("System::accept");
  order_.accepted();
  accepted_ = trial_;
}

void BatchSystem::reject() {
  order_.expect_trial("System::reject");
  take_back_step();
}

void BatchSystem::take_back_step() {
  before_step_.put_back(*graph_, *plan_);
  last_chi2_ = model_chi2_;
  order_.rejected();
}

void BatchSystem::describe_step(double chi2, IterationRecord& record) const {
  order_.expect_accepted_in_iteration("Algorithm::iterate");
  record.chi2 = accepted_.chi2;
  record.chi2_decrease = chi2 - record.chi2;
  record.step_max = accepted_.step_max;
  record.gradient_max = max_abs(gradient_);
}

}  // namespace boxplus
