// SPDX-License-Identifier: BSD-3-Clause
#include "system/batch_system.h"

#include <utility>

#include "base/stopwatch.h"
#include "base/vector_math.h"

namespace boxplus {
namespace {

/// The request. Asks to store all columns if the solver needs an operator instead of a Schur complement.
PlanRequest with_columns(PlanRequest request, const LinearSolver& solver, SchurMode schur) {
  if (schur != SchurMode::kExplicit && solver.needs() == LinearSolver::Needs::kOperator)
    request.columns = ColumnStorage::kAll;
  return request;
}

}  // namespace

BatchSystem::BatchSystem(Graph& graph, const PlanRequest& request, std::shared_ptr<LinearSolver> solver,
                         SchurMode schur)
    : model_(graph, make_plan(graph, with_columns(request, *solver, schur)), request.gauge),
      factored_(model_, std::move(solver), schur, request),
      exact_(model_, factored_),
      gauge_free_(model_, factored_, exact_),
      bounded_(model_, gauge_free_),
      trial_(graph, model_.plan) {}

void BatchSystem::configure(const Options& options, detail::Timings& timings, const StopToken& stop) {
  trial_.order().forget();
  last_chi2_ = 0;
  model_.begin_run(options, timings);
  factored_.begin_run();
  exact_.begin_run();
  set_stop(stop);
}

void BatchSystem::set_stop(const StopToken& stop) {
  model_.set_stop(stop);
  exact_.precise().set_stop(stop);
}

RunSystem::Facts BatchSystem::facts() const {
  const SchurSolver& solver = factored_.solver();
  return {.solver = solver.name(),
          .statistics = solver.statistics(),
          .workers = model_.linearizer.workers(),
          .elimination_order = solver.elimination_order()};
}

double BatchSystem::chi2() {
  const ScopedTimer adder(model_.timings->evaluate_s);
  last_chi2_ = model_.linearizer.chi2();
  stopped_ = model_.linearizer.stopped();
  return last_chi2_;
}

bool BatchSystem::linearize() {
  trial_.order().expect_no_trial("System::linearize");
  trial_.order().forget();  // until this function ends without an exception
  model_.gauge.begin_linearization();
  model_.chi2 = last_chi2_;
  exact_.precise().forget();
  factored_.linearize();
  trial_.order().linearized();
  stopped_ = model_.linearizer.stopped();
  model_.is_complete = !stopped_;
  if (stopped_) return false;
  model_.bounds.find_active(model_.graph, model_.gradient, model_.right_hand_side);
  return all_finite(gradient()) && all_finite(diagonal());
}

double BatchSystem::curvature(std::span<const double> d) {
  trial_.order().expect_vector("System::curvature", d.size(), plan().scalars());
  return model_.curvature(d);
}

StepResult BatchSystem::solve(const StepDamping& damping, std::span<double> step) {
  trial_.order().expect_vector("System::solve", step.size(), plan().scalars());
  if (!model_.is_complete) return {LinearStatus::kStopped};
  model_.gauge.begin_solve();
  const StepResult result = bounded_.solve(damping, step);
  model_.gauge.end_solve();
  return result;
}

double BatchSystem::try_step(std::span<const double> step) {
  trial_.order().expect_vector("System::try_step", step.size(), plan().scalars());
  if (has_bounds()) step = model_.bounds.clipped(step);
  const auto arrive = [&] { model_.bounds.arrive(model_.graph, step); };
  return trial_.try_step(
      {.step = step, .diagonal = diagonal(), .arrive = arrive, .chi2 = [&] { return chi2(); }});
}

void BatchSystem::reject() {
  trial_.reject();
  last_chi2_ = model_.chi2;
}

bool BatchSystem::is_free() {
  if (!plan().freedoms.empty()) return true;
  if ((plan().undetermined_blocks.empty() && !model_.gauge.has_other_types()) || !linearize()) return false;
  std::vector<double> step(plan().scalars());
  return solve({}, step).status == LinearStatus::kNotPositiveDefinite;
}

}  // namespace boxplus
