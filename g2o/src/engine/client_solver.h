// SPDX-License-Identifier: BSD-3-Clause
// Adapts a client's g2o::LinearSolver to the interface boxplus::LinearSolver.
#pragma once

#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "g2o/core/block_solver_engine.h"

namespace g2o {
namespace internal {

/// factorize() only adds the damping to copies of the diagonal blocks and lists all blocks for solve(),
/// because a client's solver factorizes and solves in one call.
class ClientSolver final : public boxplus::LinearSolver {
 public:
  /// Sets the client's solver that the next calls of solve() use.
  void set_client(const ClientLinearSolver* client) { client_ = client; }

  std::string_view name() const override { return "client"; }
  Needs needs() const override { return Needs::kBlocks; }
  void analyze(const boxplus::BlockStructure& structure, const boxplus::AnalyzeHints& hints,
               const boxplus::StopToken& stop) override;
  boxplus::FactorResult factorize(const boxplus::BlockSystem& system, const boxplus::Damping& damping,
                                  const boxplus::SolveControl& control) override;
  /// Solves for one right-hand side. Returns kNotPositiveDefinite if the client's solver fails.
  boxplus::SolveResult solve(const double* b, int columns, double* x,
                             const boxplus::SolveControl& control) override;

 private:
  const ClientLinearSolver* client_ = nullptr;
  const boxplus::BlockStructure* structure_ = nullptr;
  std::vector<int> dims_;
  std::vector<EngineBlock> blocks_;  // the blocks of the lower triangle
  std::vector<double> damped_diagonal_;
  std::vector<double> right_hand_side_, solution_;
};

}  // namespace internal
}  // namespace g2o
