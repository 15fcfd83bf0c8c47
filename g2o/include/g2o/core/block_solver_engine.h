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

/// Solves a linear system. `blocks` is the lower triangle of the matrix, and `dims` are the sizes of the
/// blocks. May change b. A BlockSolver creates this function from the LinearSolver of its client.
using ClientLinearSolver = std::function<bool(const std::vector<int>& dims,
                                              const std::vector<EngineBlock>& blocks, double* x, double* b)>;

/// The matrix H of the engine. mapHessianMemory() maps vertices and edges to the blocks of H, and then
/// constructQuadraticForm() adds to the blocks in place. λ is an argument of solve() and is never added to H.
///
/// Vectors are in the order of Hessian indices. Marginalized vertices are last.
class G2O_CORE_API BlockSolverEngine {
 public:
  BlockSolverEngine();
  BlockSolverEngine(const BlockSolverEngine&) = delete;
  BlockSolverEngine& operator=(const BlockSolverEngine&) = delete;
  ~BlockSolverEngine();

  /// Returns false, and logs a message, if two marginalized vertices share an edge.
  bool buildStructure(SparseOptimizer& optimizer, bool schur, const EngineSettings& settings);
  bool hasStructure() const;
  /// Whether the structure was built for the vertices and edges that are active now.
  bool isCurrent(const SparseOptimizer& optimizer) const;
  /// Whether H is a linearization of the vertices and edges that are active now.
  bool isLinearized(const SparseOptimizer& optimizer) const;
  size_t scalars() const;
  /// Linearizes the active edges and fills H and b.
  void buildSystem(SparseOptimizer& optimizer, double* b);
  /// Computes x = (H + λI)⁻¹ b. Returns false if the matrix is not positive definite or not finite. If the
  /// settings say EngineSolver::kNone, `client` solves the system that remains after the elimination.
  bool solve(double lambda, const double* b, double* x, const EngineSettings& settings,
             const ClientLinearSolver& client);
  /// Computes dest = H · src.
  void multiply(double* dest, const double* src) const;
  /// Computes the blocks of H⁻¹ with these Hessian indices.
  bool inverse(const std::vector<std::pair<int, int>>& blockIndices, SparseBlockMatrix<MatrixX>& spinv);
  bool save(const std::string& fileName) const;
  /// The end of each block (one past its last scalar), in the order of Hessian indices.
  std::vector<int> blockEnds() const;
  /// The number of blocks that are not eliminated. They have the first Hessian indices.
  int keptBlocks() const;
  /// Calls take(i, j, block) for every block of H with i ≤ j. i and j are Hessian indices.
  void visitBlocks(const std::function<void(int, int, const MatrixX&)>& take) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace internal
}  // namespace g2o

#endif  // G2O_BLOCK_SOLVER_ENGINE_H
