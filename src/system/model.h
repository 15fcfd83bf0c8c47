// SPDX-License-Identifier: BSD-3-Clause
// The quadratic model of F at the estimates of the last linearization, and the diagonal that a step adds to
// H.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "boxplus/system/timings.h"
#include "linearize/linearizer.h"
#include "plan/plan.h"
#include "system/bounds.h"
#include "system/gauge_removal.h"
#include "system/step_diagonal.h"

namespace boxplus {

/// What the links of the chain of step solvers (step_chain.h) share.
struct Model {
  Model(Graph& observed, Plan made, GaugePolicy policy);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  void begin_run(const Options& options, detail::Timings& timings_of_run);
  void set_stop(const StopToken& stop);

  bool stores_all_columns() const { return plan.columns == ColumnStorage::kAll; }
  std::span<const double> diagonal_of_hessian() const { return diagonal.diagonal(); }
  /// dᵀHd.
  double curvature(std::span<const double> d);
  /// Sets the gradient, the diagonal of H, the scale and the right-hand side for the blocks [first, last),
  /// whose columns begin with `values`.
  void collect(std::uint32_t first, std::uint32_t last, const double* values);
  /// The same for the blocks that are not eliminated. To be called last.
  void collect_kept();
  SolveControl control_with_right_hand_side() const;

  // ---- The diagonal matrix that a step adds to H: damping, gauge, and held entries ----

  /// Whether the matrix is λI.
  bool is_uniform(const StepDamping& damping) const;
  /// Adds the diagonal entry of H for each held scalar, and much more for entries that bounds hold: these are
  /// no gauge freedom, so the others must not move because of them.
  void hold_scalars(const StepDamping& damping);
  Damping full_damping(const StepDamping& damping);
  /// What is added to the diagonal entry of H of an entry that bounds hold.
  double stiffness(std::uint32_t scalar) const;

  Graph& graph;
  Plan plan;
  Linearizer linearizer;
  AssembledSystem assembled;
  GaugeRemoval gauge;
  Bounds bounds;
  StepDiagonal diagonal;
  std::vector<double> gradient, right_hand_side;
  double chi2 = 0;           ///< the last one that was evaluated before the last linearization
  bool is_complete = false;  ///< whether the last linearization was not stopped
  LinearizeOptions options;
  SolveControl control;
  detail::Timings* timings = nullptr;
  /// If several processes share the problem: called when a linearization has set the gradient and the
  /// diagonal of H of the edges of this process. Adds those of the other processes. The right-hand side stays
  /// that of this process.
  std::function<void()> add_other_processes;

 private:
  std::vector<double> product_;  // of curvature()
};

}  // namespace boxplus
