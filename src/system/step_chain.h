// SPDX-License-Identifier: BSD-3-Clause
// The chain of step solvers. Each link has one solve(), and asks the next one.
#pragma once

#include <span>

#include "system/factored_step.h"
#include "system/model.h"
#include "system/precise_solver.h"

namespace boxplus {

/// Computes the step in double or, if that loses a pivot because of a stiff edge, in double-double. Entries
/// that are fixed or held are 0.
class ExactStep {
 public:
  ExactStep(Model& model, FactoredStep& next)
      : model_(model), next_(next), precise_(model.graph, model.plan) {}

  void begin_run();
  StepResult solve(const StepDamping& damping, std::span<double> step);
  /// From now on, computes every step in double-double.
  void set_precise(bool precise) { is_precise_ = precise; }
  PreciseSolver& precise() { return precise_; }
  const PreciseSolver& precise() const { return precise_; }

 private:
  StepResult solve_precisely(const StepDamping& damping, std::span<double> step);

  Model& model_;
  FactoredStep& next_;
  PreciseSolver precise_;
  bool is_precise_ = false;
};

/// Removes the gauge freedom (gauge_removal.h).
class GaugeFreeStep {
 public:
  GaugeFreeStep(Model& model, FactoredStep& factored, ExactStep& next)
      : model_(model), factored_(factored), next_(next) {}

  StepResult solve(const StepDamping& damping, std::span<double> step);

 private:
  bool held_are_free(const StepDamping& damping, std::span<const double> step) const;

  Model& model_;
  FactoredStep& factored_;
  ExactStep& next_;
};

/// Keeps the step within bounds (bounds.h). If limits block it, solves again without the entries that do so.
class BoundedStep {
 public:
  BoundedStep(Model& model, GaugeFreeStep& next) : model_(model), next_(next) {}

  StepResult solve(const StepDamping& damping, std::span<double> step);
  /// RunSystem::changes_bounds().
  bool changes_bounds() const { return changes_bounds_; }

 private:
  StepResult solve_with_blocked(const StepDamping& damping, std::span<double> step);

  Model& model_;
  GaugeFreeStep& next_;
  bool changes_bounds_ = false;
};

}  // namespace boxplus
