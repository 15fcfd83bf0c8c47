// SPDX-License-Identifier: BSD-3-Clause
// The Hessian of an optimizer's active vertices and edges, in the memory of the engine.
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

/// Solves a system, given by the lower triangle of its blocks, whose sizes are `dims`. May change b. A
/// BlockSolver makes this function from the LinearSolver of its client.
using ClientLinearSolver = std::function<bool(const std::vector<int>& dims,
                                              const std::vector<EngineBlock>& blocks, double* x, double* b)>;

/// The matrix H of the engine. Vertices and edges are mapped to its blocks (mapHessianMemory), so that
/// constructQuadraticForm() adds to them in place. λ is an argument of solve() and is never written into H.
///
/// Vectors are in the order of Hessian indices, with marginalized vertices last.
class G2O_CORE_API BlockSolverEngine {
 public:
  BlockSolverEngine();
  BlockSolverEngine(const BlockSolverEngine&) = delete;
  BlockSolverEngine& operator=(const BlockSolverEngine&) = delete;
  ~BlockSolverEngine();

  /// Returns false, with a message, if two marginalized vertices share an edge.
  bool buildStructure(SparseOptimizer& optimizer, bool schur, const EngineSettings& settings);
  bool hasStructure() const;
  /// Whether the structure was built for the vertices and edges that are active now.
  bool isCurrent(const SparseOptimizer& optimizer) const;
  /// Whether H is a linearization of the vertices and edges that are active now.
  bool isLinearized(const SparseOptimizer& optimizer) const;
  size_t scalars() const;
  /// Linearizes the active edges and fills H and b.
  void buildSystem(SparseOptimizer& optimizer, double* b);
  /// x ← (H + λI)⁻¹ b. Returns false if the matrix is not positive definite or not finite. With
  /// EngineSolver::kNone, `client` solves the system that remains after the elimination.
  bool solve(double lambda, const double* b, double* x, const EngineSettings& settings,
             const ClientLinearSolver& client);
  /// dest ← H src.
  void multiply(double* dest, const double* src) const;
  /// Computes blocks of H⁻¹, by Hessian index.
  bool inverse(const std::vector<std::pair<int, int>>& blockIndices, SparseBlockMatrix<MatrixX>& spinv);
  bool save(const std::string& fileName) const;
  /// The end of each block (one past its last scalar), by Hessian index.
  std::vector<int> blockEnds() const;
  /// The number of blocks that are not eliminated. They have the first Hessian indices.
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
