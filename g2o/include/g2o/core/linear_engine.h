// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of the engine (the library boxplus), for a SparseBlockMatrix. The library's LinearSolver
// classes use these solvers.
#pragma once
#ifndef G2O_LINEAR_ENGINE_H
#define G2O_LINEAR_ENGINE_H

#if __cplusplus < 201703L
#pragma GCC system_header  // Otherwise, compilers warn about C++17 in this header.
#endif

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "g2o/core/sparse_block_matrix.h"

namespace g2o {
namespace internal {

/// The solver of the engine. kCholesky orders the blocks of the matrix, and kScalarCholesky orders its
/// scalars. kNone means that the engine does not solve the system.
enum class EngineSolver { kNone, kCholesky, kScalarCholesky, kDense, kPcg };

struct EngineSettings {
  EngineSolver solver = EngineSolver::kNone;
  double tolerance = 1e-10;        ///< kPcg: the largest accepted residual, relative to the right-hand side
  bool absoluteTolerance = false;  ///< kPcg: also stop at an absolute residual of `tolerance`
  int maxIterations = 0;           ///< kPcg: the iteration limit (0: the default of the engine)
  bool exact = false;              ///< kCholesky: never use a single-precision factor
  bool indefinite = false;         ///< kCholesky and kScalarCholesky: also solve indefinite systems
  /// Whether the algorithm expects that systems cannot be solved, and then tries again with more damping.
  bool retries = false;
};

/// A block of a symmetric matrix with row ≥ column. Its rows × cols values are stored by columns.
struct EngineBlock {
  int row, column;
  const double* values;
};

/// Factorizes matrices and solves linear systems. Reuses the symbolic analysis while the structure does not
/// change.
class G2O_CORE_API LinearEngine {
 public:
  explicit LinearEngine(const EngineSettings& settings);
  LinearEngine(const LinearEngine&) = delete;
  LinearEngine& operator=(const LinearEngine&) = delete;
  ~LinearEngine();

  /// Drops the symbolic analysis.
  void reset();
  void setSettings(const EngineSettings& settings);
  /// `dims` are the sizes of the diagonal blocks. `blocks` is the lower triangle of the matrix, sorted by
  /// column and row. It must contain every diagonal block.
  bool factorize(const std::vector<int>& dims, const std::vector<EngineBlock>& blocks);
  /// Call factorize() first. b and x may point to the same memory.
  bool solve(const double* b, double* x);
  /// Computes the given blocks (row, column) of the inverse. Calls `take` with the index in `blocks` and the
  /// value of each block, in the order of `blocks`.
  bool inverse(const std::vector<std::pair<int, int>>& blocks,
               const std::function<void(size_t, const MatrixX&)>& take);
  int iterations() const;
  /// Writes the matrix of the last factorize() for Octave. Returns false if there is no matrix yet.
  bool save(const std::string& fileName) const;

  /// Factorizes A, which is given by its upper triangle of blocks.
  template <class MatrixType>
  bool factorize(const SparseBlockMatrix<MatrixType>& A) {
    using Block = typename SparseBlockMatrix<MatrixType>::SparseMatrixBlock;
    const auto n = static_cast<int>(A.rowBlockIndices().size());
    std::vector<int> dims(static_cast<size_t>(n));
    for (int i = 0; i < n; ++i) dims[static_cast<size_t>(i)] = A.rowsOfBlock(i);
    transposed_.clear();
    std::vector<std::vector<std::pair<int, const Block*>>> columns(static_cast<size_t>(n));
    for (int c = 0; c < n; ++c) {
      for (const auto& entry : A.blockCols()[static_cast<size_t>(c)]) {
        if (entry.first <= c) columns[static_cast<size_t>(entry.first)].emplace_back(c, entry.second);
      }
    }
    size_t total = 0;
    for (const auto& column : columns)
      for (const auto& entry : column) total += static_cast<size_t>(entry.second->size());
    transposed_.resize(total);
    std::vector<EngineBlock> blocks;
    double* out = transposed_.data();
    for (int c = 0; c < n; ++c) {
      for (const auto& [row, block] : columns[static_cast<size_t>(c)]) {
        Eigen::Map<MatrixX>(out, block->cols(), block->rows()) = block->transpose();
        blocks.push_back({row, c, out});
        out += block->size();
      }
    }
    return factorize(dims, blocks);
  }

 private:
  struct State;
  std::unique_ptr<State> state_;
  std::vector<double> transposed_;
};

/// Fills `spinv` with the blocks (i, j) of the inverse of the matrix that `engine` factorized last.
G2O_CORE_API bool fillInverse(LinearEngine& engine, const std::vector<int>& dims,
                              const std::vector<std::pair<int, int>>& blockIndices,
                              SparseBlockMatrix<MatrixX>& spinv);

}  // namespace internal
}  // namespace g2o

#endif  // G2O_LINEAR_ENGINE_H
