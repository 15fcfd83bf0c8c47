// SPDX-License-Identifier: BSD-3-Clause
// Removes the gauge freedom from H in the solves of a run.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/system/system.h"
#include "system/gauge_treatment.h"

namespace boxplus {

/// Every solve after a linearization begins with the same treatment of the gauge freedom, so that its result
/// depends on no earlier solve. The next linearization begins with what was learned.
class GaugeRemoval {
 public:
  /// `graph` and `plan` must outlive this object.
  GaugeRemoval(const Graph& graph, const Plan& plan, GaugePolicy policy)
      : graph_(&graph), plan_(&plan), policy_(policy) {
    prepare_to_shorten();
  }

  /// `has_bounds` says whether any vertex has bounds. Then the motions that the plan leaves free are damped.
  void begin_run(bool has_bounds) {
    learned_.clear();
    has_bounds_ = has_bounds;
  }
  void begin_linearization() { current_ = initial_ = learned_; }
  void begin_solve() { current_ = initial_; }
  void end_solve() {
    if (current_ != initial_) learned_ = current_;
  }

  /// How solve() solves with the current treatment.
  struct Solver {
    detail::FunctionRef<StepResult()> once;
    /// The block and the scalar at which once() failed.
    detail::FunctionRef<std::pair<std::uint32_t, std::uint32_t>()> lost_pivot;
    /// Whether the edges measure none of the held directions, as far as the step of once() shows.
    detail::FunctionRef<bool()> held_are_free;
  };
  /// Solves, and changes the treatment until H is positive definite.
  StepResult solve(const Solver& solver);

  /// Makes a step as short as the motions allow that the plan's held_scalars remove. Its length is in units
  /// of the mean entry of the diagonal of H of each vertex, which does not depend on the axes of the vertex.
  /// A step that is zero in a held direction is much too long if a free motion hardly changes this direction:
  /// a point that may turn around another one moves along y on one side of it, and along x on the next.
  /// Directions of vertices without a frame, such as a focal length, do not turn, and stay held.
  /// apply_inverse(b, x) solves with the matrix of the step, and returns false if it cannot.
  void shorten(std::span<const double> diagonal, double lambda,
               detail::FunctionRef<bool(const double* b, double* x)> apply_inverse, std::span<double> step);

  /// The fraction of itself that is added to each diagonal entry.
  double fraction() const;
  bool holds_any(double lambda) const {
    return !current_.lost_scalars.empty() || current_.holds_scalars_of(*plan_, lambda);
  }
  /// Calls f(scalar) for each held scalar.
  template <class F>
  void for_each_held(double lambda, F&& f) const {
    current_.for_each_held(*plan_, lambda, f);
  }
  const GaugeTreatment& current() const { return current_; }
  const GaugeTreatment& learned() const { return learned_; }
  /// Whether any moving vertex is neither a pose nor a point. The plan contains all gauge freedom of poses
  /// and points, but not the freedom of other types.
  bool has_other_types() const;

 private:
  /// Each motion costs a solution.
  static constexpr int kMostMotions = 16;
  void prepare_to_shorten();
  StepResult hold_or_damp(StepResult result, const Solver& solver);

  const Graph* graph_;
  const Plan* plan_;
  GaugePolicy policy_;
  bool has_bounds_ = false;
  GaugeTreatment learned_;  // in this run, for the next linearization
  GaugeTreatment initial_;  // of each solve after the last linearization
  GaugeTreatment current_;  // of the current solve
  // For shorten(): the held scalars of vertices that may turn, and memory, so that no iteration allocates.
  std::vector<std::uint32_t> turning_;
  Eigen::MatrixXd motions_;
  Eigen::VectorXd weights_, unit_;
};

}  // namespace boxplus
