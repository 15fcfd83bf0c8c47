// SPDX-License-Identifier: BSD-3-Clause
// The System of a whole graph. It linearizes all edges, and computes steps with a linear solver.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "system/run_system.h"
#include "system/step_chain.h"

namespace boxplus {

class BatchSystem final : public RunSystem {
 public:
  /// Makes the plan and allocates all memory. `graph` must outlive this system. Its structure must not
  /// change. `solver` must not be null. Throws Stopped when request.stop is raised.
  BatchSystem(Graph& graph, const PlanRequest& request, std::shared_ptr<LinearSolver> solver,
              SchurMode schur);

  /// Sets the options that may differ from run to run, and reads the bounds. From now on, times are added to
  /// `timings`, and linear solvers stop when `stop` is raised.
  void configure(const Options& options, detail::Timings& timings, const StopToken& stop = {});

  double chi2() override;
  void expect(const StepDamping& damping) override { factored_.expect(damping); }
  bool linearize() override;
  std::span<const double> gradient() const override { return model_.gradient; }
  std::span<const double> diagonal() const override { return model_.diagonal.diagonal(); }
  std::span<const double> scale() const override { return model_.diagonal.scale(); }
  double curvature(std::span<const double> d) override;
  StepResult solve(const StepDamping& damping, std::span<double> step) override;
  bool clip(std::span<double> step) const override { return model_.bounds.clip(step); }
  double try_step(std::span<const double> step) override;
  bool stopped() const override { return stopped_; }

  Facts facts() const override;
  const Plan& plan() const override { return model_.plan; }
  const LinearizeOptions& linearize_options() const override { return model_.options; }
  void set_stop(const StopToken& stop) override;
  void forget_scale() override { model_.diagonal.begin_run(); }
  void reject() override;
  Trial& trial() override { return trial_; }
  /// Whether any component of the graph can move without changing an error. May factorize H at the current
  /// estimates to find out.
  bool is_free();
  bool gauge_is_free() const override { return model_.gauge.learned().holds; }
  int held_directions() const override {
    return static_cast<int>(model_.gauge.learned().lost_scalars.size());
  }
  bool damps_gauge() const override { return model_.gauge.fraction() > 0; }
  VertexRef failed_vertex() const override { return plan().block_vertex[factored_.failed_block()]; }
  bool has_bounds() const override { return !model_.bounds.empty(); }
  bool changes_bounds() const override { return bounded_.changes_bounds(); }
  /// Appends the active bounds at the last linearization, in the order of the plan.
  void report_bounds(std::vector<detail::ActiveBound>& out) const {
    model_.bounds.report(model_.graph, plan(), out);
  }
  void set_precise(bool precise) override { exact_.set_precise(precise); }
  int precise_steps() const override { return exact_.precise().steps(); }
  int affordable_precise_steps() override { return exact_.precise().affordable_steps(); }

 private:
  Model model_;
  FactoredStep factored_;
  ExactStep exact_;
  GaugeFreeStep gauge_free_;
  BoundedStep bounded_;
  Trial trial_;
  double last_chi2_ = 0;  // of the last chi2()
  bool stopped_ = false;  // of stopped()
};

}  // namespace boxplus
