// SPDX-License-Identifier: BSD-3-Clause
// BlockSolverEngine stores and factorizes the Hessian of the active vertices and edges of an optimizer. It
// connects BlockSolver to the engine, which is the library boxplus.
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

/// A function that solves a linear system by the LinearSolver of a client. `blocks` is the lower triangle of
/// the matrix, and `dims` are the sizes of the diagonal blocks. The function may change b.
using ClientLinearSolver = std::function<bool(const std::vector<int>& dims,
                                              const std::vector<EngineBlock>& blocks, double* x, double* b)>;

/// Owns the memory of the Hessian H. mapHessianMemory() maps vertices and edges to the blocks of H, and then
/// constructQuadraticForm() of each edge adds to the blocks in place. λ is an argument of solve() and is
/// never added to H.
///
/// All vectors are in the order of Hessian indices. Marginalized vertices have the last indices.
class G2O_CORE_API BlockSolverEngine {
 public:
  BlockSolverEngine();
  BlockSolverEngine(const BlockSolverEngine&) = delete;
  BlockSolverEngine& operator=(const BlockSolverEngine&) = delete;
  ~BlockSolverEngine();

  /// Returns false, and logs a message, if two marginalized vertices share an edge.
  bool buildStructure(SparseOptimizer& optimizer, bool schur, const EngineSettings& settings);
  bool hasStructure() const;
  /// Returns whether the structure was built for the vertices and edges that are active now.
  bool isCurrent(const SparseOptimizer& optimizer) const;
  /// Returns whether H is a linearization of the vertices and edges that are active now.
  bool isLinearized(const SparseOptimizer& optimizer) const;
  size_t scalars() const;
  /// Linearizes the active edges and fills H and b.
  void buildSystem(SparseOptimizer& optimizer, double* b);
  /// Computes x = (H + λI)⁻¹ b. Returns false, and logs why, if the matrix is singular, not finite, or not
  /// positive definite (allowed if settings.indefinite). If settings.solver is EngineSolver::kNone, `client`
  /// solves the system that remains after the elimination of marginalized vertices.
  bool solve(double lambda, const double* b, double* x, const EngineSettings& settings,
             const ClientLinearSolver& client);
  /// Computes dest = H · src.
  void multiply(double* dest, const double* src) const;
  /// Computes the blocks (i, j) of H⁻¹. i and j are Hessian indices.
  bool inverse(const std::vector<std::pair<int, int>>& blockIndices, SparseBlockMatrix<MatrixX>& spinv);
  bool save(const std::string& fileName) const;
  /// Returns the end of each block (one past its last scalar), in the order of Hessian indices.
  std::vector<int> blockEnds() const;
  /// Returns the number of vertices that are not eliminated. These vertices have the first Hessian indices.
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
