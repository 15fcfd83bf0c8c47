// SPDX-License-Identifier: BSD-3-Clause
// The System of a graph of which each process has a part.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "communicator.h"
#include "kept_vertices.h"
#include "shared_solver.h"
#include "system/factored_step.h"
#include "system/run_system.h"

namespace boxplus::mpi {

/// Computes with the edges of this process, as BatchSystem does with all edges, and adds what others compute.
/// All vectors have the scalars of this process's plan. In the gradient and in steps, the entries of kept
/// vertices that another process owns are zero, so that sums over all processes count each entry once.
///
/// Only Descent, between two iterations, ends a run early: computations are never stopped, because the others
/// would wait.
class DistributedSystem final : public RunSystem {
 public:
  /// Collective, as are all functions that compute.
  DistributedSystem(Communicator& communicator, Graph& graph, const PlanRequest& request,
                    std::shared_ptr<LinearSolver> solver, bool damps_gauge);

  void configure(const Options& options, detail::Timings& timings);

  double chi2() override;
  void expect(const StepDamping& damping) override { factored_.expect(damping); }
  bool linearize() override;
  std::span<const double> gradient() const override { return model_.gradient; }
  std::span<const double> diagonal() const override { return model_.diagonal.diagonal(); }
  std::span<const double> scale() const override { return model_.diagonal.scale(); }
  double curvature(std::span<const double> d) override;
  StepResult solve(const StepDamping& damping, std::span<double> step) override;
  double try_step(std::span<const double> step) override;
  double sum(double of_entries) const override { return communicator_->sum(of_entries); }
  double max(double of_entries) const override { return communicator_->max(of_entries); }

  Facts facts() const override;
  const Plan& plan() const override { return model_.plan; }
  std::uint32_t unknowns() const override { return kept_.own_unknowns(); }
  void add_up(std::span<double> of_plan, double elsewhere) override;
  const LinearizeOptions& linearize_options() const override { return model_.options; }
  void set_stop(const StopToken& /*stop*/) override {}
  void forget_scale() override { model_.diagonal.begin_run(); }
  Trial& trial() override { return trial_; }
  bool damps_gauge() const override { return damps_now_; }
  VertexRef failed_vertex() const override { return plan().block_vertex[factored_.failed_block()]; }

  const KeptVertices& kept() const { return kept_; }
  /// The id of the kept vertex at which the last failed solve() was not positive definite, in all processes.
  std::optional<Id> failed_kept() const;

 private:
  StepResult solve_once(const StepDamping& damping, std::span<double> step);
  void add_other_processes();

  Communicator* communicator_;
  Model model_;
  KeptVertices kept_;
  std::shared_ptr<SharedSolver> solver_;
  FactoredStep factored_;
  Trial trial_;
  bool may_damp_gauge_, damps_now_ = false;
  bool is_finite_ = false;        // the last linearization, in all processes
  std::vector<double> complete_;  // a vector with the entries of kept vertices of others
  std::vector<double> shared_;    // the gradient and the diagonal of H of all kept vertices
};

}  // namespace boxplus::mpi
