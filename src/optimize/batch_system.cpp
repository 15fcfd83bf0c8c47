// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/batch_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "boxplus/base/error.h"
#include "linearize/stiff_edge.h"
#include "optimize/forcing_term.h"
#include "optimize/stopwatch.h"
#include "optimize/vector_math.h"

namespace boxplus {
namespace {

/// GaugePolicy::kDamp increases each diagonal entry by this fraction of itself. This is enough to lift pivots
/// that are only rounding errors, but too little to change a step noticeably.
constexpr double kGaugeDamping = 1e-10;

/// The lower limit of the entries of the diagonal that scales the damping, as a fraction of the largest
/// entry. Smaller entries are rounding errors of Jacobians that are zero.
constexpr double kDiagonalFloor = 1e-20;

/// An entry of the scale is at least this fraction of the largest entry of the diagonal since configure().
constexpr double kMemory = 1e-7;

/// The request. Asks to store all columns if the solver needs an operator instead of a Schur complement.
PlanRequest with_columns(PlanRequest request, const LinearSolver& solver, SchurMode schur) {
  if (schur != SchurMode::kExplicit && solver.needs() != LinearSolver::Needs::kBlocks)
    request.columns = ColumnStorage::kAll;
  return request;
}

}  // namespace

BatchSystem::BatchSystem(Graph& graph, const PlanRequest& request, std::shared_ptr<LinearSolver> solver,
                         SchurMode schur)
    : graph_(&graph),
      plan_(std::make_unique<Plan>(make_plan(graph, with_columns(request, *solver, schur)))),
      before_step_(graph, *plan_),  // so that no iteration allocates, not even the first
      linearizer_(graph, *plan_),
      assembled_(plan_->structure, linearizer_.values()),
      solver_(std::move(solver), schur) {
  threads_ = request.threads;
  gauge_ = request.gauge;
  for (const Chunk& chunk : plan_->chunks) elimination_bounds_.push_back(chunk.first_column);
  elimination_bounds_.push_back(plan_->eliminated_blocks);
  solver_.analyze(plan_->structure, hints(), request.stop);
  solver_.leave_out(plan_->fixed_scalars);
  elimination_s_.resize(static_cast<std::size_t>(solver_.slices()));
  resize_vectors();
}

AnalyzeHints BatchSystem::hints() const {
  return {.threads = threads_,
          .eliminated_blocks = plan_->eliminated_blocks,
          .last = plan_->loose_blocks,
          .may_be_singular = !plan_->loose_blocks.empty(),
          .elimination_bounds = elimination_bounds_};
}

void BatchSystem::resize_vectors() {
  for (auto* vector : {&gradient_, &diagonal_, &right_hand_side_, &damping_, &scale_, &largest_diagonal_})
    vector->resize(plan_->scalars());
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
  control_ = {.relative_tolerance = forcing_term(options, *plan_), .stop = stop};
  order_.forget();
  learned_.clear();
  last_chi2_ = 0;
  is_precise_ = false;
  precise_steps_ = 0;
  expected_.reset();
  linearizer_.set_stop(stop);
  timings_ = &timings;
  std::ranges::fill(largest_diagonal_, 0);
  bounds_.read(*graph_, *plan_);
  bounded_step_.resize(bounds_.empty() ? 0 : plan_->scalars());
}

double BatchSystem::chi2() {
  const TimeAdder adder(timings_->evaluate_s);
  last_chi2_ = linearizer_.chi2();
  stopped_ = linearizer_.stopped();
  return last_chi2_;
}

bool BatchSystem::linearize() {
  order_.expect_no_trial("System::linearize");
  order_.forget();  // until this function ends without an exception
  treatment_ = initial_ = learned_;
  model_chi2_ = last_chi2_;
  precise_.forget();
  is_stiff_.reset();
  const std::optional<StepDamping> expected = std::exchange(expected_, std::nullopt);
  elimination_.reset();
  if (expected && may_eliminate_early()) {
    linearize_and_eliminate(*expected);
  } else {
    const TimeAdder adder(timings_->linearize_s);
    linearize_only();
  }
  order_.linearized();
  stopped_ = linearizer_.stopped();
  is_complete_ = !stopped_;
  if (is_complete_) bounds_.find_active(*graph_, gradient_, right_hand_side_);
  return is_complete_ && all_finite(gradient_) && all_finite(diagonal_);
}

/// Sets the gradient, the diagonal of H, the scale and the right-hand side for the blocks [first, last),
/// whose columns begin with `values`.
void BatchSystem::collect(std::uint32_t first, std::uint32_t last, const double* values) {
  const BlockStructure& structure = plan_->structure;
  const double* gradient = linearizer_.gradient().data();
  for (std::uint32_t block = first; block < last; ++block) {
    const std::uint32_t dim = structure.dim(block), offset = structure.offset[block];
    for (std::uint32_t i = 0; i < dim; ++i) {
      const double entry = values[i * (dim + 1)];
      double& largest = largest_diagonal_[offset + i];
      largest = std::max(largest, entry);
      diagonal_[offset + i] = entry;
      scale_[offset + i] = std::max(entry, kMemory * largest);
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
  floor_ = diagonal_floor();
}

void BatchSystem::collect_kept() {
  const std::uint32_t first = plan_->eliminated_blocks;
  const double* kept =
      linearizer_.values().data() + (plan_->first_value(first) - plan_->first_stored_value());
  collect(first, plan_->structure.blocks(), kept);
}

/// Whether vertices can be eliminated while other edges are still being linearized. This needs columns that
/// are final when their edges have been added, except for the rows of fixed scalars, which the solver leaves
/// out of the Schur complement. Active bounds are known only when all edges have been added.
bool BatchSystem::may_eliminate_early() const {
  const std::uint32_t first_kept = plan_->structure.offset[plan_->eliminated_blocks];
  const auto is_kept = [&](std::uint32_t scalar) { return scalar >= first_kept; };
  return solver_.slices() > 0 && bounds_.empty() &&
         std::all_of(plan_->fixed_scalars.begin(), plan_->fixed_scalars.end(), is_kept) &&
         std::all_of(plan_->held_scalars.begin(), plan_->held_scalars.end(), is_kept) &&
         std::all_of(treatment_.lost_scalars.begin(), treatment_.lost_scalars.end(), is_kept);
}

/// Linearizes all edges, and eliminates each batch of vertices. The floor of the diagonal is known only at
/// the end. Until then, assumes that it is the floor of the previous linearization. If the floor turns out to
/// be another one, and the eliminated columns depend on it, the elimination is not used.
void BatchSystem::linearize_and_eliminate(const StepDamping& damping) {
  const std::vector<std::uint32_t>& offset = plan_->structure.offset;
  const bool uniform = is_uniform(damping);
  const Damping full = uniform ? Damping{damping.lambda, nullptr} : Damping{1.0, damping_.data()};
  const double assumed = floor_;
  eliminate_batches(full, [&](const Linearizer::Batch& batch) {
    collect(batch.first, batch.last, batch.values);
    if (!uniform) fill_damping(damping, assumed, offset[batch.first], offset[batch.last]);
  });
  if (linearizer_.stopped()) return;
  collect_kept();
  floor_ = diagonal_floor();
  if (!uniform) {
    if (depends_on_floor(damping, assumed, floor_)) return;
    fill_damping(damping, floor_, offset[plan_->eliminated_blocks], plan_->scalars());
    hold_scalars(damping, floor_);
  }
  elimination_ = {damping, full};
}

/// Whether the matrix that is added to the eliminated columns differs between the floors a and b.
bool BatchSystem::depends_on_floor(const StepDamping& damping, double a, double b) const {
  const bool scales = damping.scale == Options::DampingScale::kDiagonal && damping.lambda != 0;
  if (a == b || (!scales && gauge_fraction() == 0)) return false;
  const std::uint32_t eliminated = plan_->structure.offset[plan_->eliminated_blocks];
  return std::any_of(diagonal_.begin(), diagonal_.begin() + eliminated,
                     [&](double entry) { return entry < std::max(a, b); });
}

/// Linearizes all edges. Eliminates each batch of vertices as soon as its edges have been linearized, so that
/// its columns of H are still in the cache. `before` is called before the elimination of a batch.
void BatchSystem::eliminate_batches(const Damping& damping, Linearizer::AfterBatch before) {
  SolveControl control = control_;
  control.right_hand_side = right_hand_side_.data();
  solver_.begin(damping, control);
  std::fill(elimination_s_.begin(), elimination_s_.end(), 0.0);
  const Stopwatch clock;
  linearizer_.linearize(linearize_options_, solver_.slices(), [&](const Linearizer::Batch& batch) {
    before(batch);
    const TimeAdder adder(elimination_s_[static_cast<std::size_t>(batch.group)]);
    solver_.eliminate_columns(batch.group, batch.first, batch.last, batch.values, control.stop);
  });
  const double eliminate_s = std::accumulate(elimination_s_.begin(), elimination_s_.end(), 0.0) /
                             std::min(linearizer_.workers(), solver_.slices());
  timings_->factorize_s += eliminate_s;
  timings_->linearize_s += clock.seconds() - eliminate_s;
}

double BatchSystem::curvature(std::span<const double> d) {
  order_.expect_linearization("System::curvature");
  expect_size(d, "System::curvature");
  if (!is_complete_) return std::numeric_limits<double>::quiet_NaN();
  const TimeAdder adder(timings_->solve_s);
  if (stores_all_columns()) {
    assembled_.multiply(d.data(), product_.data());
    return dot(d, product_);
  }
  if (plan_->fixed_scalars.empty()) return linearizer_.curvature(linearize_options_, d.data());
  std::copy(d.begin(), d.end(), product_.begin());
  double along_fixed = 0;  // H has only a diagonal there
  for (const std::uint32_t i : plan_->fixed_scalars) {
    along_fixed += diagonal_[i] * d[i] * d[i];
    product_[i] = 0;
  }
  return along_fixed + linearizer_.curvature(linearize_options_, product_.data());
}

/// The lower limit of the entries of the diagonal that scales the damping. It is rounded down to a power of
/// 8, so that it seldom differs from the limit of the previous linearization.
double BatchSystem::diagonal_floor() const {
  constexpr double kBits = 3;
  const double floor = std::max(kDiagonalFloor * max_abs(diagonal_), 1e-300);
  return std::isfinite(floor) ? std::exp2(kBits * std::floor(std::ilogb(floor) / kBits)) : floor;
}

/// The fraction of itself that is added to each diagonal entry to remove the gauge freedom.
double BatchSystem::gauge_fraction() const {
  const bool is_free = !plan_->freedoms.empty() || !plan_->loose_blocks.empty();
  return is_free && gauge_ == GaugePolicy::kDamp ? kGaugeDamping : treatment_.damping;
}

/// Whether the matrix to add to H is λI.
bool BatchSystem::is_uniform(const StepDamping& damping) const {
  const bool identity = damping.scale == Options::DampingScale::kIdentity || damping.lambda == 0;
  return identity && gauge_fraction() == 0 && treatment_.lost_scalars.empty() && !bounds_.holds_any() &&
         !treatment_.holds_scalars_of(*plan_, damping.lambda);
}

/// Computes the scalars [first, last) of the diagonal matrix to add to H: λD, plus the damping of the gauge.
void BatchSystem::fill_damping(const StepDamping& damping, double floor, std::uint32_t first,
                               std::uint32_t last) {
  const bool identity = damping.scale == Options::DampingScale::kIdentity || damping.lambda == 0;
  const double gauge = gauge_fraction();
  for (std::uint32_t i = first; i < last; ++i) {
    const double scale = std::max(scale_[i], floor);
    damping_[i] = damping.lambda * (identity ? 1 : scale) + gauge * scale;
  }
}

/// Adds the diagonal entry of H for each held scalar, and much more for entries that bounds hold: these are
/// no gauge freedom, so the others must not move because of them.
void BatchSystem::hold_scalars(const StepDamping& damping, double floor) {
  constexpr double kMuch = 1e8;
  treatment_.for_each_held(*plan_, damping.lambda,
                           [&](std::uint32_t i) { damping_[i] += std::max(diagonal_[i], floor); });
  bounds_.for_each_held([&](std::uint32_t i) { damping_[i] += kMuch * std::max(diagonal_[i], floor); });
}

/// The diagonal matrix to add to H.
Damping BatchSystem::full_damping(const StepDamping& damping) {
  if (is_uniform(damping)) return {damping.lambda, nullptr};
  fill_damping(damping, floor_, 0, plan_->scalars());
  hold_scalars(damping, floor_);
  return {1.0, damping_.data()};
}

/// Every solve() after a linearization begins with the same treatment of the gauge freedom, so that its
/// result depends on no earlier solve(). The next linearization begins with what was learned.
StepResult BatchSystem::solve(const StepDamping& damping, std::span<double> step) {
  order_.expect_linearization("System::solve");
  expect_size(step, "System::solve");
  if (!is_complete_) return {LinearStatus::kStopped};
  treatment_ = initial_;
  const StepResult result = solve_within_bounds(damping, step);
  if (treatment_ != initial_) learned_ = treatment_;
  return result;
}

/// Solves. If limits block the step, solves again without the entries that do so.
StepResult BatchSystem::solve_within_bounds(const StepDamping& damping, std::span<double> step) {
  constexpr int kRounds = 50;
  bounds_.forget_blocked();
  StepResult result = solve_without_gauge(damping, step);
  for (int round = 0; round < kRounds; ++round) {
    if (result.status != LinearStatus::kOk || !bounds_.find_blocked(step)) break;
    result = solve_without_gauge(damping, step);
  }
  if (result.status == LinearStatus::kOk && !bounds_.empty()) keep_within_bounds(result, step);
  return result;
}

/// Shortens a step that leaves the bounds: either only the entries that do so, or the whole step, which
/// always lowers the model of chi2. Takes the better of both.
void BatchSystem::keep_within_bounds(StepResult& result, std::span<double> step) {
  const double fraction = bounds_.longest_fraction(step);
  if (bounds_.move_blocked(step)) result.exact = false;
  if (fraction == 1) return;
  result.exact = false;
  std::ranges::copy(step, bounded_step_.begin());
  for (double& entry : bounded_step_) entry *= fraction;
  bounds_.move_blocked(bounded_step_);
  bounds_.clip(step);
  const auto decrease = [&](std::span<const double> d) { return model_decrease(gradient_, d, curvature(d)); };
  if (!(decrease(step) >= decrease(bounded_step_))) std::ranges::copy(bounded_step_, step.begin());
}

/// Solves, and finds out how to remove the gauge freedom.
StepResult BatchSystem::solve_without_gauge(const StepDamping& damping, std::span<double> step) {
  StepResult result = solve_once(damping, step);
  std::vector<std::uint32_t>& lost = treatment_.lost_scalars;
  if (result.status == LinearStatus::kOk && !held_are_gauge(damping, step)) {
    lost.clear();
    treatment_.holds = false;
    result = solve_once(damping, step);
  }
  const std::size_t before = lost.size();
  const bool may_hold = gauge_ == GaugePolicy::kFixFirst;
  while (result.status == LinearStatus::kNotPositiveDefinite && may_hold &&
         treatment_.hold_lost_pivot(*plan_, failed_block_, failed_scalar_))
    result = solve_once(damping, step);
  if (result.status == LinearStatus::kNotPositiveDefinite) {
    lost.resize(before);
    const bool holds_too_little = gauge_ == GaugePolicy::kFixFirst && !plan_->freedoms.empty();
    const bool damps_too_little = gauge_ == GaugePolicy::kDamp && has_other_types();
    if ((holds_too_little || damps_too_little) && treatment_.damping == 0) {
      treatment_.damping = kGaugeDamping;
      result = solve_once(damping, step);
    }
  }
  if (result.status == LinearStatus::kOk)
    treatment_.for_each_held(*plan_, damping.lambda, [&](std::uint32_t i) { step[i] = 0; });
  return result;
}

StepResult BatchSystem::solve_once(const StepDamping& damping, std::span<double> step) {
  StepResult result = {LinearStatus::kNotPositiveDefinite};
  if (!is_precise_) result = factorize_and_solve(damping, step);
  const bool is_lost = result.status == LinearStatus::kNotPositiveDefinite;
  if (is_precise_ || (is_lost && is_stiff() && affordable_precise_steps() > 0))
    result = solve_precisely(damping, step);
  for (const std::uint32_t i : plan_->fixed_scalars) step[i] = 0;  // exactly 0, even with a custom solver
  bounds_.for_each_held([&](std::uint32_t i) { step[i] = 0; });
  return result;
}

int BatchSystem::affordable_precise_steps() {
  constexpr double kMostMultiplications = 1e8;
  const double each = precise_.multiplications(*plan_, control_.stop);
  const double steps = std::floor(kMostMultiplications / std::max(each, 1.0)) - precise_steps_;
  return static_cast<int>(std::clamp(steps, 0.0, 1e9));
}

bool BatchSystem::is_stiff() {
  if (!is_stiff_)
    is_stiff_ = find_stiff_edge(*graph_, *plan_, linearize_options_, kStiffRatio, control_.stop).has_value();
  return *is_stiff_;
}

StepResult BatchSystem::solve_precisely(const StepDamping& damping, std::span<double> step) {
  const TimeAdder adder(timings_->solve_s);
  const FactorResult factor =
      precise_.solve(*graph_, *plan_, linearize_options_, full_damping(damping), control_.stop, step);
  if (factor.status != LinearStatus::kOk) {
    note_failure(factor.failed_block, factor.failed_scalar);
    return {factor.status};
  }
  ++precise_steps_;
  return {.exact = true};
}

/// Whether the held directions are still gauge freedom. The gradient vanishes along every free direction. So
/// if the step along held directions is larger than a rounding error, the edges measure these directions now.
/// This happens if the plan was made when poses coincided or were on a line, because more directions are free
/// at such estimates.
bool BatchSystem::held_are_gauge(const StepDamping& damping, std::span<const double> step) const {
  constexpr double kOfDecrease = 1e-9, kOfChi2 = 1e-11, kExact = 1e-20;
  double along = 0;  // the decrease of chi2 along held directions
  treatment_.for_each_held(*plan_, damping.lambda,
                           [&](std::uint32_t i) { along += diagonal_[i] * step[i] * step[i]; });
  return along <= std::max(kOfDecrease * dot(right_hand_side_, step), kOfChi2 * model_chi2_) + kExact;
}

/// Whether any moving vertex is neither a pose nor a point. The plan contains all gauge freedom of poses and
/// points, but not the freedom of other types.
bool BatchSystem::has_other_types() const {
  detail::Frame frame;
  return std::any_of(plan_->vertices.begin(), plan_->vertices.end(), [&](const VertexList& list) {
    return !list.slots.empty() && !graph_->vertex_pools()[list.pool]->get_frame(list.slots[0], frame);
  });
}

bool BatchSystem::is_free() {
  if (!plan_->freedoms.empty()) return true;
  if ((plan_->loose_blocks.empty() && !has_other_types()) || !linearize()) return false;
  std::vector<double> step(plan_->scalars());
  return solve({}, step).status == LinearStatus::kNotPositiveDefinite;
}

/// Records the block that was not positive definite. If the solver does not name it, assumes the first block
/// that the Schur complement does not eliminate.
void BatchSystem::note_failure(std::uint32_t block, std::uint32_t scalar) {
  const bool reduces = plan_->eliminated_blocks < plan_->structure.blocks();
  const std::uint32_t likely = reduces ? plan_->eliminated_blocks : 0;
  failed_block_ = block == BlockStructure::kAbsent ? likely : block;
  failed_scalar_ = scalar;
}

FactorResult BatchSystem::factorize(const StepDamping& damping) {
  SolveControl control = control_;
  control.right_hand_side = right_hand_side_.data();
  const std::optional<Elimination> elimination = std::exchange(elimination_, std::nullopt);
  if (elimination && elimination->damping == damping) {
    const TimeAdder adder(timings_->factorize_s);
    const FactorResult result = solver_.finish(linearizer_.values(), elimination->full, control);
    if (result.status == LinearStatus::kOk || result.status == LinearStatus::kStopped) return result;
  }
  const Damping full = full_damping(damping);
  if (!stores_all_columns()) {
    eliminate_batches(full, [](const Linearizer::Batch&) {});
    if (linearizer_.stopped()) return {LinearStatus::kStopped};
  }
  const TimeAdder adder(timings_->factorize_s);
  return stores_all_columns() ? solver_.factorize(assembled_, full, control)
                              : solver_.finish(linearizer_.values(), full, control);
}

/// Computes the step from the factor.
SolveResult BatchSystem::solve_factorized(std::span<double> step) {
  const TimeAdder adder(timings_->solve_s);
  if (stores_all_columns()) return solver_.solve(right_hand_side_.data(), 1, step.data(), control_);
  const SolveResult kept = solver_.solve_kept(step.data(), control_);
  if (kept.status != LinearStatus::kOk && kept.status != LinearStatus::kNotConverged) return kept;
  const std::vector<std::uint32_t>& offset = plan_->structure.offset;
  std::copy_n(right_hand_side_.data(), offset[plan_->eliminated_blocks], step.data());
  linearizer_.subtract_coupling(linearize_options_, solver_.slices(), step.data(),
                                [&](const Linearizer::Batch& batch) {
                                  for (std::uint32_t e = batch.first; e < batch.last; ++e)
                                    solver_.solve_eliminated(e, step.data() + offset[e]);
                                });
  return linearizer_.stopped() ? SolveResult{LinearStatus::kStopped} : kept;
}

StepResult BatchSystem::factorize_and_solve(const StepDamping& damping, std::span<double> step) {
  const FactorResult factor = factorize(damping);
  if (factor.status != LinearStatus::kOk) {
    note_failure(factor.failed_block, factor.failed_scalar);
    return {factor.status};
  }
  const SolveResult solved = solve_factorized(step);
  if (solved.status == LinearStatus::kNotPositiveDefinite)
    note_failure(solved.failed_block, solved.failed_scalar);
  const bool usable = solved.status == LinearStatus::kNotConverged;  // an inexact step is usable
  return {usable ? LinearStatus::kOk : solved.status, solved.iterations, solved.exact};
}

double BatchSystem::try_step(std::span<const double> step) {
  order_.expect_linearization("System::try_step");
  expect_size(step, "System::try_step");
  if (!bounds_.empty()) {
    std::ranges::copy(step, bounded_step_.begin());
    bounds_.clip(bounded_step_);
    step = bounded_step_;
  }
  double largest = 0;
  for (std::size_t i = 0; i < step.size(); ++i) largest = std::max(largest, diagonal_[i] * step[i] * step[i]);
  step_in_deviations_ = std::sqrt(largest);
  before_step_.take(*graph_, *plan_);
  order_.moved();
  try {
    for (const VertexList& list : plan_->vertices) {
      graph_->vertex_pools()[list.pool]->oplus(list.slots, list.offsets, step.data());
    }
    bounds_.snap(*graph_);
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
  if (!accepted_)
    throw InvalidArgument(
        "Algorithm::iterate: expected a call of System::accept() before the outcome kAccepted or "
        "kAcceptedShort");
  record.chi2 = accepted_->chi2;
  record.chi2_decrease = chi2 - record.chi2;
  record.step_max = accepted_->step_max;
  record.gradient_max = max_abs(gradient_);
}

void BatchSystem::expect_size(std::span<const double> vector, const char* function) const {
  if (vector.size() == plan_->scalars()) return;
  throw InvalidArgument(std::string(function) + ": expected a vector of " + std::to_string(plan_->scalars()) +
                        " entries, got " + std::to_string(vector.size()));
}

}  // namespace boxplus
