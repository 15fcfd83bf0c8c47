// SPDX-License-Identifier: BSD-3-Clause
// A trial step: moves the estimates, and takes the step back if it is rejected.
#pragma once

#include <span>

#include "boxplus/base/function_ref.h"
#include "boxplus/options/options.h"
#include "plan/estimates.h"
#include "system/call_order.h"

namespace boxplus {

class Trial {
 public:
  /// Allocates, so that no iteration does. `graph` and `plan` must outlive this object.
  Trial(Graph& graph, const Plan& plan) : graph_(&graph), plan_(&plan), before_(graph, plan) {}

  CallOrder& order() { return order_; }
  const CallOrder& order() const { return order_; }

  /// What a System knows about the step.
  struct Move {
    std::span<const double> step;      ///< within bounds
    std::span<const double> diagonal;  ///< of H
    /// Called when the estimates have moved.
    detail::FunctionRef<void()> arrive;
    detail::FunctionRef<double()> chi2;
  };
  /// Moves the estimates to x ⊞ step. Returns chi2 there. If a function of the move throws, takes the step
  /// back.
  double try_step(const Move& move);
  void accept();
  void reject();

  /// The largest entry of the last step, in standard deviations: max √Hᵢᵢ |δᵢ|. An entry's standard deviation
  /// is the one that it has if all other unknowns are known.
  double step_in_deviations() const { return step_in_deviations_; }
  /// Fills chi2, chi2_decrease and step_max for the last step that was accepted since
  /// order().begin_iteration(). `chi2` is the cost before the iteration. Throws InvalidArgument if there is
  /// no such step.
  void describe_step(double chi2, IterationRecord& record) const;

 private:
  struct Result {
    double chi2 = 0, step_max = 0;
  };
  void take_back();

  Graph* graph_;
  const Plan* plan_;
  Estimates before_;
  CallOrder order_;
  Result tried_, accepted_;  // the last ones
  double step_in_deviations_ = 0;
};

}  // namespace boxplus
