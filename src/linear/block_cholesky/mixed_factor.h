// SPDX-License-Identifier: BSD-3-Clause
// A factor in float, with solutions as good as those of one in double.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "linear/block_cholesky/numeric_factor.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/conjugate_gradients.h"

namespace boxplus {

/// The factor is the preconditioner of conjugate gradients in double: where it has any digits, each step adds
/// several to the solution, and one bad direction costs one step, which plain refinement would not forgive
/// (Higham, Accuracy and Stability of Numerical Algorithms, ch. 12; Carson and Higham 2018).
class MixedFactor {
 public:
  /// `steps_that_pay` is steps_that_pay() or, where the time does not count, infinite.
  void allocate(const SymbolicFactor& symbolic, const BlockStructure& structure, double steps_that_pay);
  /// Takes over a factor and a structure that have grown, in the same objects.
  void extend(const SymbolicFactor& symbolic) { allocate(symbolic, *structure_, steps_that_pay_); }
  /// Gives the memory of the factor back; what was factorized last is still known.
  void release();
  bool allocated() const { return factor_.allocated(); }
  /// Whether no solution has taken more steps than pay.
  bool pays() const { return most_steps_ <= steps_that_pay_; }

  /// kNotPositiveDefinite says nothing about A + λD, only that float does not do. The system must stay as it
  /// is until the last solve(); the damping is copied.
  LinearStatus factorize(std::span<const double> values, const Damping& damping, const StopToken& stop);
  /// One right-hand side. Where the status is not kOk (the factor is too rough, as a rule), x stays as it
  /// was.
  SolveResult solve(const double* b, double* x, const SolveControl& control);
  /// What was factorized last.
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
  int most_steps_ = 0;  // that a solution took
};

/// The steps that a solution usually takes where A is conditioned as graphs are.
inline constexpr double kUsualSteps = 3;

/// The steps of refinement with which a factor in float is predicted to take as long as one in double, of one
/// factorization and one solution. `seconds` and `flops` are those of the factor in double, `numbers` those
/// of its panels.
double steps_that_pay(double seconds, double flops, double numbers, const BlockStructure& structure);

}  // namespace boxplus
