// SPDX-License-Identifier: BSD-3-Clause
// A Cholesky factorization of the whole matrix as one dense square, for small or dense systems.
#pragma once

#include <vector>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

class DenseSolver final : public LinearSolver {
 public:
  std::string_view name() const override { return "dense"; }
  Needs needs() const override { return Needs::kBlocks; }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints,
               const StopToken& stop = {}) override;
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control = {}) override;
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control = {}) override;
  bool selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                        const StopToken& stop = {}) override;
  LinearStatistics statistics() const override;

 private:
  void load(const BlockSystem& system, const Damping& damping);
  bool pivot_is_lost(std::uint32_t scalar);
  void form_inverse();

  const BlockStructure* structure_ = nullptr;
  std::vector<double> matrix_, minimum_pivot_, direction_, inverse_;
  bool factorized_ = false, inverted_ = false;
};

}  // namespace boxplus
