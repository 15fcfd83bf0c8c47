// SPDX-License-Identifier: BSD-3-Clause
#include "distributed_system.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/all_finite.h"
#include "base/stopwatch.h"
#include "boxplus/mpi/distributed_optimizer.h"

namespace boxplus::mpi {
namespace {

/// What is added to each diagonal entry of H against gauge freedom, as a fraction of the entry
/// (GaugeRemoval).
constexpr double kGaugeDamping = 1e-10;

/// How many kept vertices there may be.
std::uint32_t most_kept(const LinearSolver& solver) {
  const bool is_divided = solver.needs() == LinearSolver::Needs::kContributions;
  return is_divided ? std::numeric_limits<std::uint32_t>::max() : DistributedOptimizer::kMostKept;
}

}  // namespace

DistributedSystem::DistributedSystem(Communicator& communicator, Graph& graph, const PlanRequest& request,
                                     std::shared_ptr<LinearSolver> solver, bool damps_gauge)
    : communicator_(&communicator),
      model_(graph, make_plan(graph, request), request.gauge),
      kept_(communicator, graph, model_.plan, most_kept(*solver)),
      solver_(std::make_shared<SharedSolver>(std::move(solver), communicator, kept_, request.threads)),
      factored_(model_, solver_, SchurMode::kExplicit, request),
      trial_(graph, model_.plan),
      may_damp_gauge_(damps_gauge),
      complete_(model_.plan.scalars()),
      shared_(2 * std::size_t{kept_.scalars()}) {
  model_.add_other_processes = [this] { add_other_processes(); };
}

void DistributedSystem::configure(const Options& options, detail::Timings& timings) {
  trial_.order().forget();
  damps_now_ = false;
  model_.begin_run(options, timings);
  // It depends on whether a process eliminates any vertices.
  model_.control.relative_tolerance = communicator_->max(model_.control.relative_tolerance);
  factored_.begin_run();
}

RunSystem::Facts DistributedSystem::facts() const {
  return {
      .solver = solver_->name(), .statistics = solver_->statistics(), .workers = model_.linearizer.workers()};
}

std::optional<Id> DistributedSystem::failed_kept() const {
  const std::optional<std::uint32_t> vertex = solver_->failed_vertex();
  return vertex ? std::optional(kept_.id(*vertex)) : std::nullopt;
}

double DistributedSystem::chi2() {
  const ScopedTimer adder(model_.timings->evaluate_s);
  return communicator_->sum(model_.linearizer.chi2());
}

/// Replaces the gradient and the diagonal of H of kept vertices by their sums.
void DistributedSystem::add_other_processes() {
  const std::span<double> gradient = std::span(shared_).first(kept_.scalars());
  const std::span<double> diagonal = std::span(shared_).last(kept_.scalars());
  std::ranges::fill(shared_, 0.0);
  kept_.for_each_scalar([&](std::uint32_t i, std::uint32_t all, bool) {
    gradient[all] = model_.gradient[i];
    diagonal[all] = model_.diagonal.diagonal()[i];
  });
  communicator_->add_up(shared_);
  kept_.for_each_scalar([&](std::uint32_t i, std::uint32_t all, bool own) {
    model_.gradient[i] = own ? gradient[all] : 0;
    model_.diagonal.set(i, diagonal[all]);
  });
}

void DistributedSystem::add_up(std::span<double> of_plan, double elsewhere) {
  const std::span<double> sums = std::span(shared_).first(kept_.scalars());
  std::ranges::fill(sums, 0.0);
  kept_.for_each_scalar([&](std::uint32_t i, std::uint32_t all, bool) { sums[all] = of_plan[i]; });
  communicator_->add_up(sums);
  kept_.for_each_scalar(
      [&](std::uint32_t i, std::uint32_t all, bool own) { of_plan[i] = own ? sums[all] : elsewhere; });
}

bool DistributedSystem::linearize() {
  trial_.order().expect_no_trial("System::linearize");
  trial_.order().forget();  // until this function ends without an exception
  model_.gauge.begin_linearization();
  factored_.linearize();
  trial_.order().linearized();
  model_.is_complete = true;
  is_finite_ = !communicator_->any(!all_finite(gradient()) || !all_finite(diagonal()));
  return is_finite_;
}

double DistributedSystem::curvature(std::span<const double> d) {
  trial_.order().expect_vector("System::curvature", d.size(), plan().scalars());
  std::ranges::copy(d, complete_.begin());
  kept_.complete(complete_);
  return communicator_->sum(model_.curvature(complete_));
}

StepResult DistributedSystem::solve(const StepDamping& damping, std::span<double> step) {
  trial_.order().expect_vector("System::solve", step.size(), plan().scalars());
  if (!is_finite_) return {LinearStatus::kNotFinite};
  StepResult result = solve_once(damping, step);
  if (result.status != LinearStatus::kNotPositiveDefinite || damping.lambda != 0 || !may_damp_gauge_)
    return result;
  damps_now_ = true;
  result = solve_once({kGaugeDamping, Options::DampingScale::kDiagonal}, step);
  result.exact = false;
  return result;
}

StepResult DistributedSystem::solve_once(const StepDamping& damping, std::span<double> step) {
  solver_->begin();
  StepResult result = factored_.solve(damping, step);
  result.status = solver_->end(result.status);
  result.exact = !communicator_->any(!result.exact);
  result.linear_iterations = static_cast<int>(communicator_->max(result.linear_iterations));
  if (result.status != LinearStatus::kOk) return result;
  for (const std::uint32_t i : plan().fixed_scalars) step[i] = 0;
  kept_.leave_own(step);
  return result;
}

double DistributedSystem::try_step(std::span<const double> step) {
  trial_.order().expect_vector("System::try_step", step.size(), plan().scalars());
  std::ranges::copy(step, complete_.begin());
  kept_.complete(complete_);
  return trial_.try_step(
      {.step = complete_, .diagonal = diagonal(), .arrive = [] {}, .chi2 = [&] { return chi2(); }});
}

}  // namespace boxplus::mpi
