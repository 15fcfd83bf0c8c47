// SPDX-License-Identifier: BSD-3-Clause
// The default direct solver: a supernodal multifrontal Cholesky on blocks, which needs no other library.
#pragma once

#include <vector>

#include "boxplus/linear/make_linear_solver.h"
#include "linear/block_cholesky/inverse_on_pattern.h"
#include "linear/block_cholesky/mixed_factor.h"
#include "linear/block_cholesky/numeric_factor.h"
#include "linear/block_cholesky/path_inverse.h"
#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// The method is multifrontal for three reasons. First, every front is one dense trapezoid, with 9 rows (2-D
/// chains) to 1000 rows (3-D tori). Second, only the extend-add uses indirect addresses, and analyze()
/// computes these in advance as runs of consecutive values. Third, subtrees are independent of each other, so
/// they can be factorized in parallel.
class BlockCholesky final : public LinearSolver {
 public:
  explicit BlockCholesky(const BlockCholeskyOptions& options = {}, const AmalgamationRule& rule = {})
      : options_(options), rule_(rule) {}

  std::string_view name() const override { return "block_cholesky"; }
  Needs needs() const override { return Needs::kBlocks; }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints,
               const StopToken& stop = {}) override;
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control = {}) override;
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control = {}) override;
  /// The predicted memory and time of a factor.
  struct Forecast {
    std::uint64_t bytes = 0;
    double seconds = 0;  // for one factorization on one thread
  };
  /// Predicts the cost of a factor. Completes the analysis only if `accepts` returns true for the prediction.
  template <class Accepts>
  Forecast analyze_if(Accepts&& accepts, const BlockStructure& structure, const AnalyzeHints& hints,
                      const StopToken& stop) {
    const FactorOutline outline =
        outline_factor(structure, hints.last, rule_, options_.ordering, hints.threads, hints.order, stop);
    const Forecast forecast = forecast_of(outline);
    if (accepts(forecast)) complete(outline, structure, hints, stop);
    return forecast;
  }
  bool selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                        const StopToken& stop = {}) override;
  LinearStatistics statistics() const override;
  std::span<const std::uint32_t> elimination_order() const override { return symbolic_.order; }

  const SymbolicFactor& symbolic() const { return symbolic_; }

 private:
  static Forecast forecast_of(const FactorOutline& outline);
  void complete(const FactorOutline& outline, const BlockStructure& structure, const AnalyzeHints& hints,
                const StopToken& stop);
  void leave_mixed();
  FactorResult factorize_in_double(const double* values, const Damping& damping, const StopToken& stop);
  FactorResult factorize_again_in_double(const StopToken& stop);
  FactorResult failure(std::uint32_t permuted_scalar, const double* values, const Damping& damping) const;
  enum class InverseMethod : std::uint8_t;
  InverseMethod fastest_method(std::span<const InverseRequest> requests, const PathInverse& paths) const;

  BlockCholeskyOptions options_;
  AmalgamationRule rule_;
  Ordering ordering_ = Ordering::kMinimumDegree;
  double forecast_seconds_ = 0;
  const BlockStructure* structure_ = nullptr;
  SymbolicFactor symbolic_;
  NumericFactor<double> factor_;
  MixedFactor mixed_;  // used instead of factor_ if it is allocated
  InverseOnPattern inverse_;
  int batch_ = 1;  // the number of right-hand sides for which factor_ has memory
  bool factorized_ = false, fell_back_to_double_ = false;
};

}  // namespace boxplus
