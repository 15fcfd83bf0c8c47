// SPDX-License-Identifier: BSD-3-Clause
// Linearizes the edges of a model, and computes its steps with a linear solver.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "boxplus/linear/make_linear_solver.h"
#include "linear/schur/schur_solver.h"
#include "system/model.h"
#include "system/streamed_elimination.h"

namespace boxplus {

/// The last link of the chain of step solvers. It also linearizes, because vertices can be eliminated while
/// other edges are still being linearized.
class FactoredStep {
 public:
  /// Allocates all memory. `model` must outlive this object. `solver` must not be null.
  FactoredStep(Model& model, std::shared_ptr<LinearSolver> solver, SchurMode schur,
               const PlanRequest& request);

  /// Forgets what has been expected.
  void begin_run() { expected_.reset(); }
  /// The damping of the first solve() after the next linearize().
  void expect(const StepDamping& damping) { expected_ = damping; }
  /// Computes H, the gradient and the diagonal of the model. The results are not usable if the linearizer was
  /// stopped.
  void linearize();
  StepResult solve(const StepDamping& damping, std::span<double> step);
  /// The block and the scalar at which the last failed solve() was not positive definite.
  std::uint32_t failed_block() const { return failed_block_; }
  std::uint32_t failed_scalar() const { return failed_scalar_; }
  /// Records where a solve failed. If the solver does not name the block, assumes the first block that the
  /// Schur complement does not eliminate.
  StepResult failed(LinearStatus status, std::uint32_t block, std::uint32_t scalar);

  /// Whether apply_inverse() can be called: the solver has an exact factor of the matrix of the last solve().
  bool has_factor() const { return has_factor_; }
  void forget_factor() { has_factor_ = false; }
  /// Solves with the factor. Returns false if it cannot.
  bool apply_inverse(const double* b, double* x);
  const SchurSolver& solver() const { return solver_; }

 private:
  /// What linearize() has already computed for the next solve().
  struct Elimination {
    StepDamping damping;
    Damping full;
  };

  void linearize_only();
  bool may_eliminate_early() const;
  void linearize_and_eliminate(const StepDamping& damping);
  FactorResult factorize(const StepDamping& damping);
  SolveResult solve_factorized(std::span<double> step);

  Model& model_;
  SchurSolver solver_;
  StreamedElimination streamed_;
  std::optional<StepDamping> expected_;     // of the solve() after the next linearize()
  std::optional<Elimination> elimination_;  // of the current H
  std::uint32_t failed_block_ = 0, failed_scalar_ = BlockStructure::kAbsent;
  bool has_factor_ = false;
};

}  // namespace boxplus
