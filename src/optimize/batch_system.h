// SPDX-License-Identifier: BSD-3-Clause
// The System of a whole graph. It linearizes all edges, and computes steps with a linear solver.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "boxplus/linear/make_linear_solver.h"
#include "boxplus/linearize/linearizer.h"
#include "boxplus/optimize/report.h"
#include "boxplus/optimize/system.h"
#include "linear/schur/schur_solver.h"
#include "optimize/bounds.h"
#include "optimize/call_order.h"
#include "optimize/estimates.h"
#include "optimize/gauge_removal.h"
#include "optimize/precise_solver.h"
#include "optimize/step_diagonal.h"
#include "optimize/streamed_elimination.h"
#include "plan/extend_plan.h"

namespace boxplus {

class BatchSystem final : public System {
 public:
  /// Makes the plan and allocates all memory. `graph` must outlive this system. Its structure must not
  /// change, except before extend(). `solver` must not be null. Throws Stopped when request.stop is raised.
  BatchSystem(Graph& graph, const PlanRequest& request, std::shared_ptr<LinearSolver> solver,
              SchurMode schur);

  /// Adds the elements that were added to the graph since the plan was made. `planned` tells which these are.
  /// Returns false if a new plan is needed; this system is then not usable.
  bool extend(const PlanRequest& request, const PlannedElements& planned);

  /// Sets the options that may differ from run to run, and reads the bounds. From now on, times are added to
  /// `timings`, and linear solvers stop when `stop` is raised.
  void configure(const Options& options, Report::Timings& timings, const StopToken& stop = {});
  /// Replaces the token of configure().
  void set_stop(const StopToken& stop);

  double chi2() override;
  void expect(const StepDamping& damping) override { expected_ = damping; }
  bool linearize() override;
  std::span<const double> gradient() const override { return gradient_; }
  std::span<const double> diagonal() const override { return diagonal_.diagonal(); }
  std::span<const double> scale() const override { return diagonal_.scale(); }
  double curvature(std::span<const double> d) override;
  StepResult solve(const StepDamping& damping, std::span<double> step) override;
  bool clip(std::span<double> step) const override { return bounds_.clip(step); }
  double try_step(std::span<const double> step) override;
  /// scale() forgets the diagonals of earlier linearizations.
  void forget_scale() { diagonal_.begin_run(); }
  /// The largest entry of the last step of try_step(), in standard deviations: max √Hᵢᵢ |δᵢ|. An entry's
  /// standard deviation is the one that it has if all other unknowns are known.
  double step_in_deviations() const { return step_in_deviations_; }
  /// Whether bounds shorten the last step of solve(), the step takes an entry to a limit, or it makes the
  /// gradient of an active entry point away from its limit. Then the next step may decrease chi2 much more.
  bool changes_bounds() const { return changes_bounds_; }
  void accept() override;
  void reject() override;
  bool stopped() const override { return stopped_; }

  /// If the factor in double loses a pivot, and some edge is stiff (linearize/stiff_edge.h), solve() computes
  /// the step in double-double, as long as such steps are affordable. After set_precise(true), it does so in
  /// every case.
  void set_precise(bool precise) { is_precise_ = precise; }
  /// The number of steps that were computed in double-double since configure().
  int precise_steps() const { return precise_.steps(); }
  /// The number of further steps in double-double that take about two seconds together with those since
  /// configure(). 0 if a single one takes longer. Analyzes the structure if this has not been done before.
  int affordable_precise_steps() { return precise_.affordable_steps(); }
  /// Whether solve() damps H because of the gauge, even if λ = 0.
  bool damps_gauge() const { return gauge_.fraction() > 0; }
  /// Throws InvalidArgument if an algorithm ended without accept() or reject() after its last try_step().
  void expect_no_trial() const { order_.expect_no_trial("Algorithm::iterate"); }
  void begin_iteration() { order_.begin_iteration(); }
  /// Fills chi2, chi2_decrease, step_max and gradient_max for the last step that was accepted since
  /// begin_iteration(). `chi2` is the cost before the iteration. Throws InvalidArgument if there is no such
  /// step.
  void describe_step(double chi2, IterationRecord& record) const;

  /// The bounds of the vertices, as configure() found them.
  const Bounds& bounds() const { return bounds_; }
  const Plan& plan() const { return *plan_; }
  const Linearizer& linearizer() const { return linearizer_; }
  const LinearSolver& linear_solver() const { return solver_; }
  /// The elimination order of the plan's blocks. Empty if the solver has no such order, or if the Schur
  /// complement eliminates some of the blocks.
  std::span<const std::uint32_t> elimination_order() const { return solver_.elimination_order(); }
  /// Whether any component of the graph can move without changing an error. May factorize H at the current
  /// estimates to find out.
  bool is_free();
  /// Returns false after a step has shown that edges measure a motion that the plan considers free.
  bool gauge_is_free() const { return gauge_.learned().holds; }
  /// The number of directions that are held because their pivots vanished (Plan::undetermined_blocks).
  int held_directions() const { return static_cast<int>(gauge_.learned().lost_scalars.size()); }
  /// The vertex whose block was not positive definite in the last failed solve().
  VertexRef failed_vertex() const { return plan_->block_vertex[failed_block_]; }
  const LinearizeOptions& linearize_options() const { return linearize_options_; }

 private:
  /// The result of try_step().
  struct Trial {
    double chi2 = 0, step_max = 0;
  };

  /// What linearize() has already computed for the next solve().
  struct Elimination {
    StepDamping damping;
    Damping full;
  };

  void collect(std::uint32_t first, std::uint32_t last, const double* values);
  void collect_kept();
  void linearize_only();
  bool stores_all_columns() const { return plan_->columns == ColumnStorage::kAll; }
  bool may_eliminate_early() const;
  void linearize_and_eliminate(const StepDamping& damping);
  bool is_uniform(const StepDamping& damping) const;
  void hold_scalars(const StepDamping& damping);
  Damping full_damping(const StepDamping& damping);
  double stiffness(std::uint32_t scalar) const;
  StepResult solve_with_blocked(const StepDamping& damping, std::span<double> step);
  StepResult solve_within_bounds(const StepDamping& damping, std::span<double> step);
  StepResult solve_without_gauge(const StepDamping& damping, std::span<double> step);
  StepResult solve_once(const StepDamping& damping, std::span<double> step);
  StepResult solve_precisely(const StepDamping& damping, std::span<double> step);
  bool held_are_free(const StepDamping& damping, std::span<const double> step) const;
  StepResult factorize_and_solve(const StepDamping& damping, std::span<double> step);
  FactorResult factorize(const StepDamping& damping);
  SolveResult solve_factorized(std::span<double> step);
  StepResult failed(LinearStatus status, std::uint32_t block, std::uint32_t scalar);
  void take_back_step();
  AnalyzeHints hints() const;
  SolveControl control_with_right_hand_side() const;
  void resize_vectors();

  Graph* graph_;
  std::unique_ptr<Plan> plan_;
  Estimates before_step_;
  Linearizer linearizer_;
  AssembledSystem assembled_;
  SchurSolver solver_;
  StreamedElimination streamed_;
  GaugeRemoval gauge_;
  StepDiagonal diagonal_;
  CallOrder order_;
  std::vector<double> gradient_, right_hand_side_;
  std::vector<double> product_;  // of curvature(), if all columns are stored
  std::vector<std::uint32_t> elimination_bounds_;
  Trial trial_;                             // the last one
  Trial accepted_;                          // the last one that was accepted
  std::optional<StepDamping> expected_;     // of the solve() after the next linearize()
  std::optional<Elimination> elimination_;  // of the current H
  std::uint32_t failed_block_ = 0, failed_scalar_ = BlockStructure::kAbsent;
  Bounds bounds_;
  double last_chi2_ = 0;   // of the last chi2()
  double model_chi2_ = 0;  // at the estimates of the last linearization
  double step_in_deviations_ = 0;
  PreciseSolver precise_;
  bool is_precise_ = false;
  bool has_factor_ = false;   // whether the linear solver has a factor of the matrix of the last solve_once()
  bool stopped_ = false;      // of stopped()
  bool is_complete_ = false;  // whether the last linearization was not stopped
  bool changes_bounds_ = false;
  LinearizeOptions linearize_options_;
  SolveControl control_;
  int threads_ = 1;
  std::optional<bool> extensible_;  // the result of is_extensible(), once it is known
  Report::Timings* timings_ = nullptr;
};

}  // namespace boxplus
