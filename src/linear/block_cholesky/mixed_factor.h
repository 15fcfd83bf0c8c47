// SPDX-License-Identifier: BSD-3-Clause
// A factor in float. Its solutions are refined to the accuracy of double.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "linear/block_cholesky/numeric_factor.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/conjugate_gradients.h"

namespace boxplus {

/// The factor is the preconditioner of conjugate gradients in double. If the factor has any correct digits,
/// each step adds several correct digits to the solution. In a direction in which the factor is wrong, plain
/// iterative refinement would diverge, but conjugate gradients need only one more step (Higham, Accuracy and
/// Stability of Numerical Algorithms, ch. 12; Carson and Higham 2018).
class MixedFactor {
 public:
  /// `steps_that_pay` is the result of steps_that_pay(), or infinite if time does not matter.
  void allocate(const SymbolicFactor& symbolic, const BlockStructure& structure, double steps_that_pay);
  /// Frees the memory of the factor. values() and damping() keep their results.
  void release();
  bool allocated() const { return factor_.allocated(); }
  /// Whether all solutions so far took few enough steps to be faster than a factor in double.
  bool pays() const { return most_steps_ <= steps_that_pay_; }

  /// Factorizes A + λD in float. If this returns kNotPositiveDefinite, A + λD may still be positive definite,
  /// because float may not be accurate enough. `values` must not change until the last solve(), but the
  /// damping is copied.
  LinearStatus factorize(std::span<const double> values, const Damping& damping, const StopToken& stop);
  /// Solves for one right-hand side. If the status is not kOk, usually because the factor is too inaccurate,
  /// x does not change.
  SolveResult solve(const double* b, double* x, const SolveControl& control);
  /// The values that were factorized last.
  std::span<const double> values() const { return system_->values(); }
  Damping damping() const { return {1, damping_.data()}; }

 private:
  const SymbolicFactor* symbolic_ = nullptr;
  const BlockStructure* structure_ = nullptr;
  std::optional<AssembledSystem> system_;
  NumericFactor<float> factor_;
  ConjugateGradients refinement_;
  std::vector<double> damping_, solution_;
  double steps_that_pay_ = 0;
  int most_steps_ = 0;  // the largest number of steps of one solution so far
};

/// The number of steps that a solution usually takes for matrices of pose graphs.
inline constexpr double kUsualSteps = 3;

/// The break-even number of refinement steps: with this many steps, one factorization and one solution are
/// predicted to take as long in float as in double. `seconds` and `flops` describe the factorization in
/// double. `numbers` is the number of values in the panels.
double steps_that_pay(double seconds, double flops, double numbers, const BlockStructure& structure);

}  // namespace boxplus
