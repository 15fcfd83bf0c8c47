// SPDX-License-Identifier: BSD-3-Clause
// The Hessian of an optimizer's active vertices and edges in the engine's memory.
#pragma once
#ifndef G2O_BLOCK_SOLVER_ENGINE_H
#define G2O_BLOCK_SOLVER_ENGINE_H

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "g2o/core/linear_engine.h"

namespace g2o {

class SparseOptimizer;

namespace internal {

/// Solves a system whose lower triangle of blocks is given, with blocks of `dims`; may change b. A
/// BlockSolver makes it of the LinearSolver that its client gave it.
using ClientLinearSolver = std::function<bool(const std::vector<int>& dims,
                                              const std::vector<EngineBlock>& blocks, double* x, double* b)>;

/// H of the engine: its blocks are mapped into vertices and edges (mapHessianMemory), so that
/// constructQuadraticForm() adds to them where they lie. λ is an argument of solve() and never written into
/// H.
///
/// Vectors are in the order of Hessian indices: marginalized vertices last.
class G2O_CORE_API BlockSolverEngine {
 public:
  BlockSolverEngine();
  BlockSolverEngine(const BlockSolverEngine&) = delete;
  BlockSolverEngine& operator=(const BlockSolverEngine&) = delete;
  ~BlockSolverEngine();

  /// False, with a message, where two marginalized vertices share an edge.
  bool buildStructure(SparseOptimizer& optimizer, bool schur, const EngineSettings& settings);
  bool hasStructure() const;
  /// Whether what takes part is what the structure was built for.
  bool isCurrent(const SparseOptimizer& optimizer) const;
  /// Whether H is that of a linearization of what takes part.
  bool isLinearized(const SparseOptimizer& optimizer) const;
  size_t scalars() const;
  /// Linearizes the active edges and fills H and b.
  void buildSystem(SparseOptimizer& optimizer, double* b);
  /// x ← (H + λI)⁻¹ b; false if that is not positive definite or not finite. With EngineSolver::kNone
  /// `client` solves what is left after the elimination.
  bool solve(double lambda, const double* b, double* x, const EngineSettings& settings,
             const ClientLinearSolver& client);
  /// dest ← H src.
  void multiply(double* dest, const double* src) const;
  /// Blocks of H⁻¹ by Hessian index.
  bool inverse(const std::vector<std::pair<int, int>>& blockIndices, SparseBlockMatrix<MatrixX>& spinv);
  bool save(const std::string& fileName) const;
  /// One past the last scalar of each block, by Hessian index.
  std::vector<int> blockEnds() const;
  /// The number of blocks that are not eliminated: they have the first Hessian indices.
  int keptBlocks() const;
  /// Calls take(i, j, block) for every block (i, j) of H, i ≤ j, by Hessian index.
  void visitBlocks(const std::function<void(int, int, const MatrixX&)>& take) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace internal
}  // namespace g2o

#endif  // G2O_BLOCK_SOLVER_ENGINE_H
