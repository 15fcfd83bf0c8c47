// SPDX-License-Identifier: BSD-3-Clause
// The interface between a BlockSolver and the solver of its sparse systems.
#pragma once
#ifndef G2O_LINEAR_SOLVER_H
#define G2O_LINEAR_SOLVER_H

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "g2o/core/linear_engine.h"
#include "g2o/core/marginal_covariance_cholesky.h"
#include "g2o/core/sparse_block_matrix.h"
#include "g2o/stuff/timeutil.h"

namespace g2o {

/// Solves A x = b for a symmetric positive definite A that is given by its upper triangle of blocks.
template <typename MatrixType>
class LinearSolver {
 public:
  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;
  virtual ~LinearSolver() = default;

  /// Called before the first system with a new structure.
  virtual bool init() = 0;
  virtual bool solve(const SparseBlockMatrix<MatrixType>& A, double* x, double* b) = 0;

  /// Computes the diagonal blocks of A⁻¹. Allocates `blocks` if it is null (see deallocateBlocks).
  virtual bool solveBlocks(double**& blocks, const SparseBlockMatrix<MatrixType>& A) {
    (void)blocks;
    (void)A;
    return false;
  }
  /// Computes the blocks (i, j) of A⁻¹.
  virtual bool solvePattern(SparseBlockMatrix<MatrixX>& spinv,
                            const std::vector<std::pair<int, int>>& blockIndices,
                            const SparseBlockMatrix<MatrixType>& A) {
    (void)spinv;
    (void)blockIndices;
    (void)A;
    return false;
  }

  virtual bool writeDebug() const { return false; }
  virtual void setWriteDebug(bool) {}

  static void allocateBlocks(const SparseBlockMatrix<MatrixType>& A, double**& blocks) {
    const size_t n = A.rowBlockIndices().size();
    blocks = new double*[n];
    for (size_t i = 0; i < n; ++i) {
      const auto dim = static_cast<size_t>(A.rowsOfBlock(static_cast<int>(i)));
      blocks[i] = new double[dim * dim];
    }
  }
  static void deallocateBlocks(const SparseBlockMatrix<MatrixType>& A, double**& blocks) {
    for (size_t i = 0; i < A.rowBlockIndices().size(); ++i) delete[] blocks[i];
    delete[] blocks;
    blocks = nullptr;
  }

  /// Expands a permutation of blocks to a permutation of scalars.
  template <typename BlockDerived, typename ScalarDerived>
  static void blockToScalarPermutation(const SparseBlockMatrix<MatrixType>& A,
                                       const Eigen::MatrixBase<BlockDerived>& p,
                                       const Eigen::MatrixBase<ScalarDerived>& scalar) {
    auto& out = const_cast<Eigen::MatrixBase<ScalarDerived>&>(scalar);
    Eigen::Index at = 0;
    for (Eigen::Index i = 0; i < p.size(); ++i) {
      for (int j = 0; j < A.colsOfBlock(p(i)); ++j) out(at++) = A.colBaseOfBlock(p(i)) + j;
    }
  }

  /// Returns the settings of an equivalent solver of the engine (the library boxplus). A BlockSolver then
  /// uses the engine instead of solve(), and does not build a SparseBlockMatrix. By default, returns
  /// EngineSolver::kNone, so that a BlockSolver calls solve().
  virtual internal::EngineSettings engine() const { return {}; }
};

/// The base class of solvers that use compressed columns. A derived class can implement solveBlocks_impl() to
/// support the computation of marginal covariances.
template <typename MatrixType>
class LinearSolverCCS : public LinearSolver<MatrixType> {
 public:
  bool solveBlocks(double**& blocks, const SparseBlockMatrix<MatrixType>& A) override {
    return solveBlocks_impl(A, [&](MarginalCovarianceCholesky& inverse) {
      if (blocks == nullptr) this->allocateBlocks(A, blocks);
      inverse.computeCovariance(blocks, A.rowBlockIndices());
    });
  }
  bool solvePattern(SparseBlockMatrix<MatrixX>& spinv, const std::vector<std::pair<int, int>>& blockIndices,
                    const SparseBlockMatrix<MatrixType>& A) override {
    return solveBlocks_impl(A, [&](MarginalCovarianceCholesky& inverse) {
      inverse.computeCovariance(spinv, A.rowBlockIndices(), blockIndices);
    });
  }

  bool blockOrdering() const { return _blockOrdering; }
  /// If blockOrdering is true, the fill-reducing ordering permutes blocks. Otherwise, it permutes scalars.
  virtual void setBlockOrdering(bool blockOrdering) { _blockOrdering = blockOrdering; }
  bool writeDebug() const override { return _writeDebug; }
  void setWriteDebug(bool b) override { _writeDebug = b; }

 protected:
  /// Calls `compute` with the Cholesky factor of A. Returns false if A has no Cholesky factor.
  virtual bool solveBlocks_impl(const SparseBlockMatrix<MatrixType>& A,
                                std::function<void(MarginalCovarianceCholesky&)> compute) {
    (void)A;
    (void)compute;
    return false;
  }
  /// Makes _ccsMatrix a view of the blocks of A. A must outlive _ccsMatrix.
  void initMatrixStructure(const SparseBlockMatrix<MatrixType>& A) {
    _ccsMatrix = std::make_unique<SparseBlockMatrixCCS<MatrixType>>(A.rowBlockIndices(), A.colBlockIndices());
    A.fillSparseBlockMatrixCCS(*_ccsMatrix);
  }

  std::unique_ptr<SparseBlockMatrixCCS<MatrixType>> _ccsMatrix;
  bool _blockOrdering = true;
  bool _writeDebug = true;
};

}  // namespace g2o

#endif  // G2O_LINEAR_SOLVER_H
